#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "pbrt/util/diagnostics.h"

// CLI11 takes five seconds to compile, so that the rooms know its App by this name alone.
namespace CLI {
class App;
}

// Programs made of sub-commands. Nothing is printed here: a run returns what to print, so that
// tests call what users call.
namespace pbrt::cli {

using Args = std::span<const std::string>;

/// Output of a command and exit code of the process.
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

/// Runs a command that takes options, spelled as pbrt allows; of one given twice the last counts.
/// `define` binds options (options.h) to variables, `run` finds them filled; `--help` and
/// `--version` are added. Where the command line asks for one of these, or is mistaken, the result
/// says so and `run` is not called.
Outcome RunWithOptions(Args args, const std::string &name, const std::string &description,
                       const std::function<void(CLI::App *app)> &define,
                       const std::function<Outcome()> &run);

/// The same where the variables are members of an Options.
template <typename Options>
Outcome RunWithOptions(Args args, const std::string &name, const std::string &description,
                       void (*define)(CLI::App *app, Options *options),
                       Outcome (*run)(Options &options)) {
    Options options;
    return RunWithOptions(
        args, name, description, [&](CLI::App *app) { define(app, &options); },
        [&] { return run(options); });
}

/// The end of a command: `out` and the warnings of the log, or its errors and exit code 1.
Outcome Finish(const Diagnostics &log, std::string out = {});

/// Prints it; the result is main's: 1 where standard output takes less than all of it.
int Print(const Outcome &outcome);

}  // namespace pbrt::cli
