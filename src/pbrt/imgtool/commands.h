#pragma once

#include <string_view>

#include "pbrt/cli/tool.h"

namespace pbrt::imgtool {

using cli::Args;
using cli::Outcome;

extern const cli::Tool kTool;

/// The user's mistake.
inline Outcome Failure(std::string_view reason) {
    return cli::Failure("imgtool", reason);
}

Outcome Assemble(Args args);
Outcome Average(Args args);
Outcome Bloom(Args args);
Outcome Cat(Args args);
Outcome Check(Args args);
Outcome Convert(Args args);
Outcome Denoise(Args args);
Outcome Diff(Args args);
Outcome Error(Args args);
Outcome FalseColor(Args args);
Outcome Info(Args args);
Outcome MakeEquiArea(Args args);
Outcome Merge(Args args);
Outcome ScaleNormalMap(Args args);
Outcome SplitN(Args args);
Outcome WhiteBalanced(Args args);

}  // namespace pbrt::imgtool
