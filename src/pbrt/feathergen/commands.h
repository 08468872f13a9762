#pragma once

#include <string_view>

#include "pbrt/cli/tool.h"

namespace pbrt::feathergen {

using cli::Args;
using cli::Outcome;

/// The program: `args` without its name. `neck` first: a covered neck; else one feather.
Outcome Run(Args args);

Outcome FeatherCommand(Args args);
Outcome NeckCommand(Args args);

/// The user's mistake.
inline Outcome Failure(std::string_view reason) {
    return cli::Failure("feathergen", reason);
}

}  // namespace pbrt::feathergen
