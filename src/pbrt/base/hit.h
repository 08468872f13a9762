#pragma once

#include <bit>
#include <cstdint>

#include "pbrt/util/ray_packet.h"

namespace pbrt {

/// Hit that a ray tracer returns for a ray: compact, no derivatives. u, v are barycentrics of the
/// second and third vertex for triangles; for bilinear patches the patch's (u, v), or, in planar
/// meshes, the coordinates described at BilinearMesh::planar; for other shapes what their Intersect
/// gives, 0 where they need none.
struct Hit {
    float t;
    float u, v;
    uint32_t geometry;        ///< index into RenderScene::geometries
    uint32_t primitive;       ///< triangle, patch... within it
    uint32_t instance = ~0u;  ///< index into RenderScene::instances; ~0u: none
};

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

/// Sixteen hits and the rays that found them, both in the space of what was hit: rendering space,
/// or an instance's object space.
struct RayHits {
    HitPacket hit;
    Point3fX16 o;
    Vector3fX16 d;

    Ray RayAt(int i) const { return {Lane(o, i), Lane(d, i)}; }
};

/// Number in [0, 8) of the direction's octant, to sort rays by.
inline uint32_t Octant(Vector3f d) {
    return uint32_t(d.x < 0) | uint32_t(d.y < 0) << 1 | uint32_t(d.z < 0) << 2;
}

inline UintX16 Octant(const Vector3fX16 &d) {
    const auto bit = [](const FloatX16 &x, uint32_t b) { return Select(x < 0, b, 0u); };
    return bit(d.x, 1) | bit(d.y, 2) | bit(d.z, 4);
}

}  // namespace pbrt
