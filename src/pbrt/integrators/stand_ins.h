#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pbrt/integrators/path/path.h"

namespace pbrt {

/// Integrators of pbrt-v4 that scenes name and that are not built here: `path` renders the same
/// picture, but for light that only they find.
std::vector<std::string_view> StandInNames();
/// `path` in the place of the integrator of this name, which takes that one's parameters and warns
/// at its directive; nullopt where the name is none of StandInNames().
std::optional<PathIntegrator> CreateStandIn(std::string_view name, ParamDict &params);

}  // namespace pbrt
