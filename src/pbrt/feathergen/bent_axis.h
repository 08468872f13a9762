#pragma once

#include "pbrt/util/vecmath.h"

namespace pbrt::feathergen {

using Vec3d = Vec3<double>;
inline Vector3f Rounded(Vec3d v) {
    return {float(v.x), float(v.y), float(v.z)};
}

/// Right-handed and orthonormal: forward x left = up.
struct AxisFrame {
    Vec3d forward, left, up;
};

/// A curve whose direction turns evenly: to the left by `turn` and down by `droop`, both in radians
/// over its whole length. The frame keeps its left-hand side level with the base's.
struct BentAxis {
    Vec3d root;
    AxisFrame base;
    double length = 1;
    double azimuth = 0, turn = 0;  ///< from base.forward to base.left: at the root, and added
    double rise = 0, droop = 0;    ///< towards base.up: at the root, and taken away

    double Azimuth(double u) const { return azimuth + turn * u; }
    double Elevation(double u) const { return rise - droop * u; }
    /// u in [0, 1] from root to tip.
    AxisFrame At(double u) const;
    /// Error below 1e-9 of the length while the turns stay below 3 rad.
    Vec3d Point(double u) const;
};

}  // namespace pbrt::feathergen
