#pragma once

#include <bit>
#include <vector>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/rounding.h"

namespace pbrt {

// What the sixteen-wide code of triangle and bilinear meshes has in common.

namespace detail {

/// v[lane] from from[lane].
inline Vector3fX16 LoadVectors(const std::array<const Vector3f *, kPacketSize> &from) {
    Vector3fX16 v;
    for (int i = 0; i < kPacketSize; ++i)
        SetLane(&v, i, *from[size_t(i)]);
    return v;
}
inline Point2fX16 LoadVectors(const std::array<const Point2f *, kPacketSize> &from) {
    Point2fX16 v;
    for (int i = 0; i < kPacketSize; ++i)
        SetLane(&v, i, *from[size_t(i)]);
    return v;
}

/// Primitives of meshes side by side.
template <typename Mesh, int kCorners>
struct MeshPacket {
    const ShapePacket<Mesh> &mesh;
    std::array<const uint32_t *, kPacketSize> index;
    LaneBits flipped = 0;

    /// Lanes outside `active` repeat one of it, as `meshes` do.
    MeshPacket(const ShapePacket<Mesh> &meshes, const UintX16 &primitive, LaneBits active)
        : mesh(meshes) {
        const int first = std::countr_zero(active);
        for (int i = 0; i < kPacketSize; ++i) {
            const int from = active >> i & 1 ? i : first;
            const size_t k = size_t(i);
            index[k] = &mesh[k]->indices[kCorners * size_t(primitive[from])];
            flipped |= LaneBits(mesh[k]->flipNormal) << i;
        }
    }
    /// Lanes whose mesh has such an attribute.
    template <typename V>
    LaneBits Have(std::vector<V> Mesh::*attribute) const {
        LaneBits lanes = 0;
        for (int i = 0; i < kPacketSize; ++i)
            lanes |= LaneBits(!(mesh[size_t(i)]->*attribute).empty()) << i;
        return lanes;
    }
    /// The attribute at a corner; 0 in lanes that have none.
    template <typename V>
    auto At(int corner, std::vector<V> Mesh::*attribute) const {
        static constexpr V kNone{};
        std::array<const V *, kPacketSize> from;
        for (size_t i = 0; i < kPacketSize; ++i) {
            const std::vector<V> &values = mesh[i]->*attribute;
            from[i] = values.empty() ? &kNone : &values[index[i][corner]];
        }
        return LoadVectors(from);
    }
    IntX16 FaceIndices(const UintX16 &primitive) const {
        IntX16 face = BitCast<int32_t>(primitive);
        for (int i = 0; i < kPacketSize; ++i) {
            const auto &given = mesh[size_t(i)]->faceIndices;
            if (!given.empty())
                face.Set(
                    i,
                    given[size_t(index[size_t(i)] - mesh[size_t(i)]->indices.data()) / kCorners]);
        }
        return face;
    }
};

/// Turns n to the outside, and interpolated normals, where the mesh has them, say what that is.
template <typename Packet, typename Interpolated>
inline void SetNormals(const Packet &meshes, LaneBits smooth, const Interpolated &interpolated,
                       SurfaceInteractionX16 *s) {
    s->n = s->ns = Select(MaskOf(meshes.flipped), -s->n, s->n);
    if (smooth == 0) return;
    s->ns = UnitOr(interpolated(), s->n);
    s->n = FaceForward(s->n, s->ns);
}

}  // namespace detail

}  // namespace pbrt
