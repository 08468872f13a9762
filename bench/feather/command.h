#pragma once

#include "pbrt/cli/tool.h"

namespace pbrt::bench {

/// The program bench_feather: the words behind its name, and what it prints.
cli::Outcome Run(cli::Args args);

}  // namespace pbrt::bench
