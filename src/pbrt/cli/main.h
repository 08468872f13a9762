#pragma once

#include <functional>
#include <string_view>

#include "pbrt/cli/tool.h"

namespace pbrt::cli {

/// The line that manuals have for the option that every program takes.
inline constexpr std::string_view kMemoryLimitHelp =
    "--memory-limit SIZE  take no more memory than this, as in 4G, and refuse what needs more";

/// A program's `main`: runs `run` with the words behind the program's name and returns its exit
/// code. What every program has in common stands here: `--memory-limit`, anywhere before "--", and
/// a sentence with exit code 1 where memory runs out or a library throws.
int Main(std::string_view program, int argc, char **argv, const std::function<int(Args)> &run);

}  // namespace pbrt::cli
