#pragma once

#include <algorithm>
#include <cmath>

#include "pbrt/util/vecmath.h"

// What undoes the warps of pbrt/util/sampling.h: each Invert takes its Sample's result to u.
namespace pbrt {

inline Point2f InvertUniformDiskConcentric(Point2f p) {
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float along = wide ? p.x : p.y, across = wide ? p.y : p.x;
    const float r = std::copysign(std::sqrt(p.x * p.x + p.y * p.y), along);
    const float other = along == 0 ? 0 : std::atan(across / along) * (4 / Pi) * r;
    const float a = wide ? r : other, b = wide ? other : r;
    return {(a + 1) / 2, (b + 1) / 2};
}
inline Point2f InvertCosineHemisphere(Vector3f w) {
    return InvertUniformDiskConcentric({w.x, w.y});
}

/// Angle of (x, y) as a part of a turn, in [0, 1).
inline float TurnsOf(float x, float y) {
    const float turns = std::atan2(y, x) * (InvPi / 2);
    return std::min(turns < 0 ? turns + 1 : turns, OneMinusEpsilon);
}

inline Point2f InvertUniformCone(Vector3f w, float oneMinusCosTheta) {
    // 1 - z = (x^2 + y^2) / (1 + z) does not cancel near the axis.
    const float d = w.z > 0 ? (w.x * w.x + w.y * w.y) / (1 + w.z) : 1 - w.z;
    return {d / oneMinusCosTheta, TurnsOf(w.x, w.y)};
}
inline Point2f InvertUniformTriangle(Point2f b) {
    return b.x < b.y ? Point2f{2 * b.x, b.x + b.y} : Point2f{b.x + b.y, 2 * b.y};
}

/// Density of SampleTent.
inline float TentPDF(float x, float r) {
    return std::max(0.f, r - std::abs(x)) / (r * r);
}
inline float InvertTent(float x, float r) {
    const float t = 1 - std::abs(x) / r;
    return x < 0 ? t * t / 2 : 1 - t * t / 2;
}

}  // namespace pbrt
