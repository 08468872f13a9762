#pragma once

#include "pbrt/util/math.h"

namespace pbrt {

// Warps of uniform numbers u in [0, 1) and their densities. Directions are about +z, densities per
// unit solid angle, area or length. T: float or FloatX16.

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

template <AnyFloat T>
inline Vec3<T> SampleCosineHemisphere(Vec2<T> u) {
    const Vec2<T> d = SampleUniformDiskConcentric(u);
    return {d.x, d.y, SafeSqrt(1 - d.x * d.x - d.y * d.y)};
}
template <AnyFloat T>
inline T CosineHemispherePDF(T cosTheta) {
    return cosTheta * InvPi;
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

/// Tent of half width r about 0.
inline float SampleTent(float u, float r) {
    return u < 0.5f ? -r * (1 - std::sqrt(2 * u)) : r * (1 - std::sqrt(2 - 2 * u));
}

}  // namespace pbrt
