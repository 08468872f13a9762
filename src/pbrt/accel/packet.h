#pragma once

#include "pbrt/shapes/surface_interaction.h"
#include "pbrt/util/ray_packet.h"

namespace pbrt {

/// What a packet's rays have in common. It decides how the nearest hits are looked for, not what
/// they are. (Shadow rays gain nothing, not even from one pixel's points to one light.)
enum class Coherence {
    None,
    Octant,  ///< most have directions of the same signs: twice as fast in scenes of few primitives
    Alike,   ///< start side by side in nearly one direction, as a pixel's camera rays: four times
};

/// Number in [0, 8) of the direction's octant, to sort rays by.
inline uint32_t Octant(Vector3f d) {
    return uint32_t(d.x < 0) | uint32_t(d.y < 0) << 1 | uint32_t(d.z < 0) << 2;
}

inline UintX16 Octant(const Vector3fX16 &d) {
    const auto bit = [](const FloatX16 &x, uint32_t b) { return Select(x < 0, b, 0u); };
    return bit(d.x, 1) | bit(d.y, 2) | bit(d.z, 4);
}

/// Sixteen of Hit.
struct alignas(64) HitPacket {
    FloatX16 t, u, v;
    UintX16 geometry, primitive, instance;

    Hit At(int i) const { return {t[i], u[i], v[i], geometry[i], primitive[i], instance[i]}; }
    void Set(int i, const Hit &hit) {
        t.Set(i, hit.t), u.Set(i, hit.u), v.Set(i, hit.v);
        geometry.Set(i, hit.geometry), primitive.Set(i, hit.primitive);
        instance.Set(i, hit.instance);
    }
};

}  // namespace pbrt
