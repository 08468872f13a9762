#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "pbrt/util/diagnostics.h"

// Programs made of sub-commands. Nothing is printed here: a run returns what to print, so that
// tests call what users call.
namespace pbrt::cli {

using Args = std::span<const std::string>;

/// What a command prints and how the process ends.
struct Outcome {
    int exitCode = 0;
    std::string out, err;
};

struct Command {
    std::string_view name, summary;
    Outcome (*run)(Args args);  ///< `args` without the command's name
};

struct Tool {
    std::string_view name;
    std::string_view usage;             ///< after the program's name, e.g. "<command> files..."
    std::span<const Command> commands;  ///< in alphabetical order
};

/// The tool as a whole: `args` without the program's name. No arguments, `help` or `help
/// <command>`: the manual. An unknown command is an error with the nearest name.
Outcome Run(const Tool &tool, Args args);

/// The user's mistake: "<tool>: reason" and exit code 1.
Outcome Failure(std::string_view tool, std::string_view reason);

/// Fills the variables bound to `app`'s options, spelled as pbrt allows; of an option given twice
/// the last counts. Adds `--version`. Something is returned where the command ends here: help, the
/// version, or a mistake.
std::optional<Outcome> Parse(CLI::App *app, Args args);

/// Runs a command that takes options: `define` binds those of `app` to an Options, `run` has it
/// filled. Help, the version and the user's mistakes end as Parse has them.
template <typename Options>
Outcome RunWithOptions(Args args, const std::string &name, const std::string &description,
                       void (*define)(CLI::App *app, Options *options),
                       Outcome (*run)(Options &options)) {
    CLI::App app(description, name);
    Options options;
    define(&app, &options);
    if (std::optional<Outcome> end = Parse(&app, args)) return *std::move(end);
    return run(options);
}

/// The end of a command: `out` and the warnings of the log, or its errors and exit code 1.
Outcome Finish(const Diagnostics &log, std::string out = {});

/// Prints it; the result is main's: 1 where standard output takes less than all of it.
int Print(const Outcome &outcome);

}  // namespace pbrt::cli
