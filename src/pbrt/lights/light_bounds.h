#pragma once

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Cone of directions about a unit axis; cosTheta 1: the axis alone, -1: all directions.
struct DirectionCone {
    Vector3f axis{0, 0, 1};
    float cosTheta = -1;
};
/// Smallest cone with a common plane that holds both.
DirectionCone Union(const DirectionCone &a, const DirectionCone &b);

/// Where a light (or several) stands, where to it shines and how much, after Conty Estevez and
/// Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting".
struct LightBounds {
    Bounds3f bounds;
    DirectionCone normals;  ///< of all emitters
    float cosTheta_e = 0;   ///< cosine of how far off its normal each emitter shines
    float power = 0;
    bool twoSided = false;

    /// Estimate of the light that arrives at p, never 0 where some does. `n`: the receiver's
    /// normal, 0 where it takes light from all sides; light from behind it counts as well, since
    /// surfaces may be seen from either side.
    float Importance(Point3f p, Normal3f n) const;
};
/// Bounds of both; empty ones (power 0) take no part.
LightBounds Union(const LightBounds &a, const LightBounds &b);

/// What Importance reads, in the form that light trees keep.
struct LightCluster {
    Point3f center;
    float radius2 = 0;
    Vector3f axis;
    float cosTheta_o = -1, cosTheta_e = 0;
    float signedPower = 0;  ///< negative: two-sided

    LightCluster() = default;
    explicit LightCluster(const LightBounds &b);
};

/// Power times the largest cosine at the emitters over squared distance, times the largest cosine
/// at the receiver. `n` as above, its use being `hasNormal`. Free of branches, so that loops over
/// clusters vectorise.
inline float Importance(Point3f center, float radius2, Vector3f axis, float cosTheta_o,
                        float cosTheta_e, float signedPower, Point3f p, Normal3f n,
                        bool hasNormal) {
    const Vector3f d = center - p;
    const float d2 = LengthSquared(d), invD = 1 / std::sqrt(std::max(d2, 1e-30f));
    const float power = std::abs(signedPower);
    // theta_b: half angle of the cluster's sphere from p.
    const bool inside = d2 <= radius2;
    const float sin2_b = inside ? 0 : radius2 * invD * invD;
    const float sin_b = std::sqrt(sin2_b);
    const float cos_b = inside ? -1 : std::sqrt(std::max(0.f, 1 - sin2_b));
    // theta_w, from the axis to p, less theta_o and theta_b.
    const float cosAxis = -Dot(axis, d) * invD;
    const float cos_w = std::min(1.f, signedPower < 0 ? std::abs(cosAxis) : cosAxis);
    const float sin_w = std::sqrt(std::max(0.f, 1 - cos_w * cos_w));
    const float sin_o = std::sqrt(std::max(0.f, 1 - cosTheta_o * cosTheta_o));
    const bool inCone = cos_w >= cosTheta_o;
    const float cos_x = inCone ? 1 : cos_w * cosTheta_o + sin_w * sin_o;
    const float sin_x = inCone ? 0 : sin_w * cosTheta_o - cos_w * sin_o;
    const float cosEmitter = cos_x >= cos_b ? 1 : cos_x * cos_b + sin_x * sin_b;
    // theta_i, from the receiver's normal, less theta_b.
    const float cos_i = std::min(1.f, std::abs(Dot(n, d)) * invD);
    const float sin_i = std::sqrt(std::max(0.f, 1 - cos_i * cos_i));
    const float cosNear = cos_i >= cos_b ? 1 : cos_i * cos_b + sin_i * sin_b;
    const float cosReceiver = hasNormal ? std::max(cosNear, 1e-4f) : 1;
    // Rounding must not turn a grazing emitter off: hence the floors of 1e-4.
    const float lit =
        power * std::max(cosEmitter, 1e-4f) * cosReceiver / std::max(std::max(d2, radius2), 1e-30f);
    return cosEmitter > cosTheta_e - 1e-4f ? std::min(lit, 1e30f) : 0;
}

inline float Importance(const LightCluster &c, Point3f p, Normal3f n) {
    return Importance(c.center, c.radius2, c.axis, c.cosTheta_o, c.cosTheta_e, c.signedPower, p, n,
                      n != Normal3f{});
}

}  // namespace pbrt
