#pragma once

#include "pbrt/cli/tool.h"
#include "pbrt/pbrt/command_line.h"

namespace pbrt::program {

/// What the program does with its command line.
cli::Outcome Run(Arguments &arguments);

}  // namespace pbrt::program
