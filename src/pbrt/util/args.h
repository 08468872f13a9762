#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pbrt {

/// One option of a program, named without the leading dashes ("crop-window").
struct ArgOption {
    std::string name;
    bool takesValue;
};

/// Command line in one spelling: options as `--name` or `--name=value` with the name as the program
/// spells it, the rest as it was.
struct NormalizedArgs {
    std::vector<std::string> args;
    std::string error;    ///< empty: none; else a sentence for the user
    std::string unknown;  ///< the unknown option that it is about: lower case, without - and _
};

/// True if an option spelled so, dashes included, is the one of this name.
bool IsSpellingOf(std::string_view spelled, std::string_view name);

/// Accepts pbrt's spellings: one or two dashes, `--name value` or `--name=value`, and in names
/// case,
/// `-` and `_` ignored. The word after an option that takes a value is its value whatever it begins
/// with; elsewhere `-`, and words that begin with a dash and a digit or point, are no options.
/// After
/// `--` all words are left alone. `-h` means `--help`. Unknown options (with the nearest known
/// name) and missing values are errors. `args` is without the program's name.
NormalizedArgs NormalizeArgs(std::span<const std::string> args, std::span<const ArgOption> options);

/// The options of a CLI::App (a template so that this room needs no CLI11).
template <typename App>
std::vector<ArgOption> ArgOptionsOf(const App &app) {
    std::vector<ArgOption> options;
    for (const auto *option : app.get_options())
        for (const std::string &name : option->get_lnames())
            options.push_back({name, option->get_items_expected_max() > 0});
    return options;
}

}  // namespace pbrt
