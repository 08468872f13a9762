#pragma once

#include "pbrt/scene/params.h"
#include "pbrt/util/transform.h"

namespace pbrt {

inline constexpr PointParam kLightFrom{"from", "point3", {0, 0, 0}, "where the light stands"};

/// A light's place and the direction into which it shines, of any length, in its own space.
struct FromTo {
    Point3f from;
    Vector3f along;
};
/// Reads `from` and `to`. An error where their distance is 0, or has no square in float, there or
/// in rendering space.
FromTo GetFromTo(ParamDict &params, const Transform &renderFromLight);

}  // namespace pbrt
