#pragma once

#include <span>

#include "pbrt/util/check.h"
#include "pbrt/util/math.h"

namespace pbrt {

// Warps of uniform numbers u in [0, 1) and their densities. Directions are about +z, densities per
// unit solid angle, area or length; each Invert undoes its Sample. T: float or FloatX16.

/// Index drawn with probability proportional to `weights` (none negative, not all 0), its
/// probability, and what is left of u. For a handful of weights; many: AliasTable.
struct DiscreteSample {
    int index;
    float pmf, u;
};
inline DiscreteSample SampleDiscrete(std::span<const float> weights, float u) {
    float sum = 0;
    for (float w : weights)
        sum += w;
    DCHECK(sum > 0);
    float place = u * sum;
    int i = 0, last = 0;
    for (; i < int(weights.size()); ++i) {
        const float w = weights[size_t(i)];
        if (w > 0) {
            last = i;
            if (place < w) return {i, w / sum, std::min(place / w, OneMinusEpsilon)};
        }
        place -= w;
    }
    return {last, weights[size_t(last)] / sum, OneMinusEpsilon};
}

/// Weight of a sample drawn with density f where another way has density g (Veach 1997).
template <AnyFloat T>
inline T PowerHeuristic(T f, T g) {
    // Beyond 1e18 squares overflow.
    return Select(f > 1e18f, 1.f, f * f / (f * f + g * g));
}

/// Unit disk, area-preserving and continuous (Shirley and Chiu 1997).
template <AnyFloat T>
inline Vec2<T> SampleUniformDiskConcentric(Vec2<T> u) {
    const T a = 2 * u.x - 1, b = 2 * u.y - 1;
    const auto wide = Abs(a) > Abs(b);
    const T r = Select(wide, a, b), other = Select(wide, b, a);
    // An eighth of a turn each side of the axis along r.
    const SinCosT<T> angle = SinCosQuarters(T(0.5f * Select(r == 0, other, other / r)));
    const T cos = r * angle.cos, sin = r * angle.sin;
    return {Select(wide, cos, sin), Select(wide, sin, cos)};
}
inline Point2f InvertUniformDiskConcentric(Point2f p) {
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float along = wide ? p.x : p.y, across = wide ? p.y : p.x;
    const float r = std::copysign(std::sqrt(p.x * p.x + p.y * p.y), along);
    const float other = along == 0 ? 0 : std::atan(across / along) * (4 / Pi) * r;
    const float a = wide ? r : other, b = wide ? other : r;
    return {(a + 1) / 2, (b + 1) / 2};
}

template <AnyFloat T>
inline Vec3<T> SampleCosineHemisphere(Vec2<T> u) {
    const Vec2<T> d = SampleUniformDiskConcentric(u);
    return {d.x, d.y, SafeSqrt(1 - d.x * d.x - d.y * d.y)};
}
template <AnyFloat T>
inline T CosineHemispherePDF(T cosTheta) {
    return cosTheta * InvPi;
}
inline Point2f InvertCosineHemisphere(Vector3f w) {
    return InvertUniformDiskConcentric({w.x, w.y});
}

/// Angle of (x, y) as a part of a turn, in [0, 1).
inline float TurnsOf(float x, float y) {
    const float turns = std::atan2(y, x) * (InvPi / 2);
    return std::min(turns < 0 ? turns + 1 : turns, OneMinusEpsilon);
}

/// Cone of half angle theta about +z; u.x = 0 is the axis. `oneMinusCosTheta` in (0, 2]: small
/// angles keep their digits so.
inline Vector3f SampleUniformCone(Point2f u, float oneMinusCosTheta) {
    const float d = u.x * oneMinusCosTheta;  // 1 - z
    const float r = SafeSqrt(d * (2 - d));
    const SinCos phi = SinCosTurns(u.y);
    return {r * phi.cos, r * phi.sin, 1 - d};
}
inline float UniformConePDF(float oneMinusCosTheta) {
    return InvPi / 2 / oneMinusCosTheta;
}
inline Point2f InvertUniformCone(Vector3f w, float oneMinusCosTheta) {
    // 1 - z = (x^2 + y^2) / (1 + z) does not cancel near the axis.
    const float d = w.z > 0 ? (w.x * w.x + w.y * w.y) / (1 + w.z) : 1 - w.z;
    return {d / oneMinusCosTheta, TurnsOf(w.x, w.y)};
}

inline Vector3f SampleUniformHemisphere(Point2f u) {
    return SampleUniformCone(u, 1);
}
inline constexpr float UniformHemispherePDF = InvPi / 2;
inline Vector3f SampleUniformSphere(Point2f u) {
    return SampleUniformCone(u, 2);
}
inline constexpr float UniformSpherePDF = InvPi / 4;

/// Barycentric coordinates of vertices 0 and 1 (the third is the rest), uniform over a triangle;
/// keeps neighbours together (Heitz 2019, "A Low-Distortion Map Between Triangle and Square").
inline Point2f SampleUniformTriangle(Point2f u) {
    const bool upper = u.x < u.y;
    const float half = (upper ? u.x : u.y) / 2;
    return upper ? Point2f{half, u.y - half} : Point2f{u.x - half, half};
}
inline Point2f InvertUniformTriangle(Point2f b) {
    return b.x < b.y ? Point2f{2 * b.x, b.x + b.y} : Point2f{b.x + b.y, 2 * b.y};
}

/// Tent of half width r about 0.
inline float SampleTent(float u, float r) {
    return u < 0.5f ? -r * (1 - std::sqrt(2 * u)) : r * (1 - std::sqrt(2 - 2 * u));
}
inline float TentPDF(float x, float r) {
    return std::max(0.f, r - std::abs(x)) / (r * r);
}
inline float InvertTent(float x, float r) {
    const float t = 1 - std::abs(x) / r;
    return x < 0 ? t * t / 2 : 1 - t * t / 2;
}

}  // namespace pbrt
