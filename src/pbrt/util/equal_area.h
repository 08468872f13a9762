#pragma once

#include "pbrt/util/vecmath.h"

namespace pbrt {

// Equal-area map between the unit square and the sphere (Clarberg 2008, "Fast Equal-Area Mapping of
// the (Hemi)Sphere using SIMD"), laid out as pbrt-v4's environment pictures: the square's centre is
// +z, its corners are -z, its edges' middles are +-x (horizontal) and +-y (vertical, +y at v = 1).

/// Unit direction of p in [0, 1]^2; areas on the sphere are 4 pi times those in the square.
inline Vector3f EqualAreaSquareToSphere(Point2f p) {
    const float u = 2 * p.x - 1, v = 2 * p.y - 1;
    // Fold the four outer triangles (lower hemisphere) over the edges of the inner diamond.
    const bool lower = std::abs(u) + std::abs(v) > 1;
    const float a = lower ? 1 - std::abs(v) : std::abs(u);
    const float b = lower ? 1 - std::abs(u) : std::abs(v);
    // The diamond a + b = r maps to the circle at height 1 - r^2: both enclose the share r^2.
    const float r = a + b;
    const float phi = r > 0 ? (Pi / 2) * (b / r) : 0;
    const float height = 1 - r * r, radius = r * SafeSqrt(2 - r * r);
    return {std::copysign(radius * std::cos(phi), u), std::copysign(radius * std::sin(phi), v),
            lower ? -height : height};
}

/// Inverse of EqualAreaSquareToSphere for a unit vector d; the result lies in [0, 1]^2.
/// Round trip: 1e-6 in the square.
inline Point2f EqualAreaSphereToSquare(Vector3f d) {
    const float x = std::abs(d.x), y = std::abs(d.y);
    // r^2 = 1 - |z|, without the cancellation near the poles.
    const float r = std::min(1.f, std::sqrt((x * x + y * y) / (1 + std::abs(d.z))));
    const float b = r * (2 / Pi) * std::atan2(y, x), a = r - b;
    const bool lower = d.z < 0;
    const float u = std::copysign(lower ? 1 - b : a, d.x),
                v = std::copysign(lower ? 1 - a : b, d.y);
    return {std::clamp((u + 1) / 2, 0.f, 1.f), std::clamp((v + 1) / 2, 0.f, 1.f)};
}

/// Where a picture's neighbourhood goes on beyond the square's edges: each edge is glued to itself,
/// turned about its middle. p in [-1, 2]^2.
inline Point2f WrapEqualAreaSquare(Point2f p) {
    if (p.x < 0 || p.x > 1) p = {p.x < 0 ? -p.x : 2 - p.x, 1 - p.y};
    if (p.y < 0 || p.y > 1) p = {1 - p.x, p.y < 0 ? -p.y : 2 - p.y};
    return p;
}

}  // namespace pbrt
