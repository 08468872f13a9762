#pragma once

#include "pbrt/cli/tool.h"
#include "pbrt/pbrt/command_line.h"

namespace pbrt::program {

/// Runs the program by its command line.
cli::Outcome Run(Arguments &arguments);

}  // namespace pbrt::program
