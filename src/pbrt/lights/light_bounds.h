#pragma once

#include "pbrt/base/light.h"

namespace pbrt {

/// Smallest cone with a common plane that holds both.
DirectionCone Union(const DirectionCone &a, const DirectionCone &b);

/// Bounds of both; empty ones (power 0) take no part.
LightBounds Union(const LightBounds &a, const LightBounds &b);

/// Data that Importance reads, in the form that light trees keep. T is float, or FloatX16 for
/// sixteen clusters.
template <AnyFloat T>
struct ClusterOf {
    Vec3<T> center;
    T radius;  ///< of a sphere that holds all emitters; above 0
    Vec3<T> axis;
    T spread;  ///< length of the chord from the axis to the cone's rim, 2 sin(theta_o / 2)
    T cosTheta_e;
    T signedPower;  ///< negative: two-sided
};
ClusterOf<float> Cluster(const LightBounds &bounds);

/// Point at which light arrives, in the form that Importance reads.
struct Receiver {
    Receiver() = default;
    Receiver(Point3f p, Normal3f n) : p(p), n(n), least(n == Normal3f{} ? 1 : kMargin) {}
    /// Margin of cosines: rounding must not turn grazing light off.
    static constexpr float kMargin = 1e-4f;
    Point3f p;
    Normal3f n;       ///< 0: takes light from all sides
    float least = 1;  ///< added to the cosine
};

/// Power times the largest cosine at the emitters over squared distance, times the largest cosine
/// at the receiver. 0 only where nothing can arrive; at most 1e30.
///
/// The cosines are bounds without angles: a unit vector that turns by theta moves by a chord of 2
/// sin(theta / 2), and so changes its cosine to another one by no more. From outside the cluster's
/// sphere its half angle has the sine s = radius / distance; s + s^3 is at least its chord, and 2
/// from inside.
template <AnyFloat T>
T Importance(const ClusterOf<T> &c, const Receiver &to) {
    const Vec3<T> d{c.center.x - to.p.x, c.center.y - to.p.y, c.center.z - to.p.z};
    const T invD = RsqrtApprox(Max(LengthSquared(d), c.radius * c.radius));
    const T s = c.radius * invD;
    const T away = -Dot(c.axis, d);
    const T facing = Select(c.signedPower < 0, Abs(away), away) * invD;
    // 1.001 for the root's error.
    const T cosEmitter = facing + (c.spread + s * (1.001f * s * s + 1));
    const T along = to.n.x * d.x + (to.n.y * d.y + (to.n.z * d.z + c.radius));
    const T cosReceiver = Clamp(along * invD + to.least, 0.f, 1.f);
    constexpr float kMargin = Receiver::kMargin;
    const T lit =
        Abs(c.signedPower) * Clamp(cosEmitter, kMargin, 1.f) * cosReceiver * (invD * invD);
    return Select(cosEmitter > c.cosTheta_e - kMargin, Min(lit, 1e30f), 0.f);
}

/// Estimate of the light that arrives at p, never 0 where some does. `n`: the receiver's normal on
/// the side where it takes light, 0 where it takes light from all sides.
float Importance(const LightBounds &light, Point3f p, Normal3f n);

}  // namespace pbrt
