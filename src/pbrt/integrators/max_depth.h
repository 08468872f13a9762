#pragma once

#include "pbrt/scene/param_row.h"

namespace pbrt {

/// Parameter that integrators that follow paths share.
inline constexpr IntParam kMaxDepth{"maxdepth", 5, 0, 1 << 20,
                                    "scattering events of the longest path"};

}  // namespace pbrt
