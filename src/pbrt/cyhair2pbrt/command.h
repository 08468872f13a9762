#pragma once

#include "pbrt/cli/tool.h"

namespace pbrt::cyhair2pbrt {

/// The program; `args` without its name.
cli::Outcome Run(cli::Args args);

}  // namespace pbrt::cyhair2pbrt
