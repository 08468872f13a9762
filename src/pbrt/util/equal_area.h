#pragma once

#include "pbrt/util/atan2.h"

namespace pbrt {

// Equal-area map between the unit square and the sphere (Clarberg 2008, "Fast Equal-Area Mapping of
// the (Hemi)Sphere using SIMD"), laid out as pbrt-v4's environment images: the square's centre is
// +z, its corners are -z, its edges' middles are +-x (horizontal) and +-y (vertical, +y at v = 1).
// T: float or FloatX16.

/// Unit direction of p in [0, 1]^2; areas on the sphere are 4 pi times those in the square.
template <AnyFloat T>
inline Vec3<T> EqualAreaSquareToSphere(Vec2<T> p) {
    const T u = 2 * p.x - 1, v = 2 * p.y - 1;
    // Fold the four outer triangles (lower hemisphere) over the edges of the inner diamond.
    const auto lower = Abs(u) + Abs(v) > 1;
    const T a = Select(lower, 1 - Abs(v), Abs(u));
    const T b = Select(lower, 1 - Abs(u), Abs(v));
    // The diamond a + b = r maps to the circle at height 1 - r^2: both enclose the share r^2.
    const T r = a + b;
    const SinCosT<T> phi = SinCosTurns(T(0.25f * Select(r > 0, b / r, 0.f)));
    const T height = 1 - r * r, radius = r * SafeSqrt(2 - r * r);
    return {CopySign(radius * phi.cos, u), CopySign(radius * phi.sin, v),
            Select(lower, -height, height)};
}

/// Inverse of EqualAreaSquareToSphere for a unit vector d; the result lies in [0, 1]^2.
/// Round trip: 1e-6 in the square.
template <AnyFloat T>
inline Vec2<T> EqualAreaSphereToSquare(Vec3<T> d) {
    const T x = Abs(d.x), y = Abs(d.y);
    // r^2 = 1 - |z|, without the cancellation near the poles.
    const T r = Min(Sqrt((x * x + y * y) / (1 + Abs(d.z))), 1.f);
    const T b = r * (2 / Pi) * FastAtan2(y, x), a = r - b;
    const auto lower = d.z < 0;
    const T u = CopySign(Select(lower, 1 - b, a), d.x), v = CopySign(Select(lower, 1 - a, b), d.y);
    return {Clamp((u + 1) / 2, 0.f, 1.f), Clamp((v + 1) / 2, 0.f, 1.f)};
}

}  // namespace pbrt
