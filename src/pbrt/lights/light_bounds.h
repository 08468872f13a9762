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

/// What importance is made of, in the form that light trees keep. F is float, or four floats for
/// four clusters at a time.
template <typename F>
struct ClusterOf {
    F centerX, centerY, centerZ, radius2;
    F axisX, axisY, axisZ;
    F cosTheta_o, cosTheta_e;
    F signedPower;  ///< negative: two-sided
};
ClusterOf<float> Cluster(const LightBounds &bounds);

using FourFloats = float __attribute__((vector_size(16)));

// Written here since neither compiler vectorises the scalar form's branches.
template <typename F>
F Larger(F a, F b) {
    return a > b ? a : b;
}
template <typename F>
F Smaller(F a, F b) {
    return a < b ? a : b;
}
inline float RootOf(float a) {
    return std::sqrt(a);
}
inline FourFloats RootOf(FourFloats a) {
    return FourFloats{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

/// Power times the largest cosine at the emitters over squared distance, times the largest cosine
/// at the receiver; n = 0: without that. 0 only where nothing can arrive; at most 1e30.
template <typename F>
F Importance(const ClusterOf<F> &c, Point3f p, Normal3f n) {
    const F zero{}, one = zero + 1;
    const F dx = c.centerX - p.x, dy = c.centerY - p.y, dz = c.centerZ - p.z;
    const F d2 = dx * dx + dy * dy + dz * dz, invD = one / RootOf(Larger(d2, zero + 1e-30f));
    // theta_b: half angle of the cluster's sphere from p.
    const auto inside = d2 <= c.radius2;
    const F sin2_b = inside ? zero : c.radius2 * invD * invD;
    const F sin_b = RootOf(sin2_b);
    const F cos_b = inside ? -one : RootOf(Larger(zero, one - sin2_b));
    // theta_w, from the axis to p, less theta_o and theta_b.
    const F cosAxis = -(c.axisX * dx + c.axisY * dy + c.axisZ * dz) * invD;
    const F eitherWay = c.signedPower < 0 ? Larger(cosAxis, -cosAxis) : cosAxis;
    const F cos_w = Smaller(one, eitherWay);
    const F sin_w = RootOf(Larger(zero, one - cos_w * cos_w));
    const F sin_o = RootOf(Larger(zero, one - c.cosTheta_o * c.cosTheta_o));
    const auto inCone = cos_w >= c.cosTheta_o;
    const F cos_x = inCone ? one : cos_w * c.cosTheta_o + sin_w * sin_o;
    const F sin_x = inCone ? zero : sin_w * c.cosTheta_o - cos_w * sin_o;
    const F cosEmitter = cos_x >= cos_b ? one : cos_x * cos_b + sin_x * sin_b;
    // Rounding must not turn grazing light off: hence the floors of 1e-4, here and below.
    F lit = Larger(c.signedPower, -c.signedPower) * Larger(cosEmitter, zero + 1e-4f) /
            Larger(Larger(d2, c.radius2), zero + 1e-30f);
    if (n != Normal3f{}) {
        // theta_i, from the receiver's normal, less theta_b.
        const F along = (n.x * dx + n.y * dy + n.z * dz) * invD;
        const F cos_i = Smaller(one, Larger(along, -along));
        const F sin_i = RootOf(Larger(zero, one - cos_i * cos_i));
        const F cosReceiver = cos_i >= cos_b ? one : cos_i * cos_b + sin_i * sin_b;
        lit *= Larger(cosReceiver, zero + 1e-4f);
    }
    return cosEmitter > c.cosTheta_e - 1e-4f ? Smaller(lit, zero + 1e30f) : zero;
}

}  // namespace pbrt
