#pragma once

#include "pbrt/scene/param_row.h"

namespace pbrt {

// Parameters that integrators that follow paths share.
inline constexpr IntParam kMaxDepth{"maxdepth", 5, 0, 1 << 20,
                                    "scattering events of the longest path"};
inline constexpr BoolParam kRegularize{"regularize", false,
                                       "surfaces are rougher after a path's first rough one"};

}  // namespace pbrt
