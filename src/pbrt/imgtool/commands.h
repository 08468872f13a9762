#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pbrt::imgtool {

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

/// In alphabetical order.
std::span<const Command> Commands();

/// imgtool as a whole: `args` without the program's name. No arguments, `help` or `help <command>`:
/// the manual.
Outcome Run(Args args);

Outcome Average(Args args);
Outcome Check(Args args);
Outcome Convert(Args args);
Outcome Diff(Args args);
Outcome Error(Args args);
Outcome Info(Args args);
Outcome MakeEquiArea(Args args);

}  // namespace pbrt::imgtool
