#pragma once

#include "pbrt/cli/tool.h"

namespace pbrt::plytool {

extern const cli::Tool kTool;

cli::Outcome Cat(cli::Args args);
cli::Outcome Info(cli::Args args);
cli::Outcome Split(cli::Args args);

}  // namespace pbrt::plytool
