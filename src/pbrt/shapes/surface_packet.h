#pragma once

#include <array>

#include "pbrt/accel/packet.h"
#include "pbrt/shapes/surface.h"

namespace pbrt {

/// What sixteen rays have met, each its own shape.
struct PacketHits {
    std::array<const Shape *, kPacketSize> shape;
    HitPacket hit;
    Point3fX16 o;  ///< of the rays; object space, where the shape is an instance's
    Vector3fX16 d;
};

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
    std::array<const Mesh *, kPacketSize> mesh;
    std::array<const uint32_t *, kPacketSize> index;
    LaneBits flipped = 0;

    /// Lanes outside `active` repeat one of it.
    MeshPacket(const PacketHits &met, LaneBits active) {
        const int first = std::countr_zero(active);
        for (int i = 0; i < kPacketSize; ++i) {
            const int from = active >> i & 1 ? i : first;
            const size_t k = size_t(i);
            mesh[k] = std::get_if<Mesh>(met.shape[size_t(from)]);
            index[k] = &mesh[k]->indices[kCorners * size_t(met.hit.primitive[from])];
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

using TrianglePacket = MeshPacket<TriangleMesh, 3>;
using PatchPacket = MeshPacket<BilinearMesh, 4>;

template <typename V>
auto CornersOf(const TrianglePacket &t, std::vector<V> TriangleMesh::*attribute) {
    return Corners<decltype(t.At(0, attribute))>{t.At(0, attribute), t.At(1, attribute),
                                                 t.At(2, attribute)};
}

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

/// TriangleSurface sixteen times. kWithTangents: with dpdu, dpdv, dpdus, uv and faceIndex, else
/// these are undefined.
template <bool kWithTangents>
inline SurfaceInteractionX16 TriangleSurfaces(const PacketHits &met, LaneBits active) {
    const detail::TrianglePacket t(met, active);
    const Corners<Point3fX16> p = detail::CornersOf(t, &TriangleMesh::p);
    const Corners<FloatX16> b{1 - met.hit.u - met.hit.v, met.hit.u, met.hit.v};
    SurfaceInteractionX16 s;
    PlaceOnTriangle<true>(p, b, &s);
    detail::SetNormals(
        t, t.Have(&TriangleMesh::n),
        [&] { return Interpolate(b, detail::CornersOf(t, &TriangleMesh::n)); }, &s);
    if constexpr (kWithTangents) {
        const Vector3fX16 e1 = p.v1 - p.v0, e2 = p.v2 - p.v0;
        s.uv = {b.v1 + b.v2, b.v2};
        s.dpdu = e1;
        s.dpdv = p.v2 - p.v1;
        if (const LaneBits given = t.Have(&TriangleMesh::uv)) {
            const MaskX16 mask = MaskOf(given);
            const auto uv = detail::CornersOf(t, &TriangleMesh::uv);
            SurfaceInteractionX16 own = s;
            SetTangents(e1, e2, uv.v1 - uv.v0, uv.v2 - uv.v0, &own);
            s.dpdu = Select(mask, own.dpdu, s.dpdu);
            s.dpdv = Select(mask, own.dpdv, s.dpdv);
            s.uv = Select(mask, Interpolate(b, uv), s.uv);
        }
        s.dpdus = s.dpdu;
        if (t.Have(&TriangleMesh::s)) {
            const Vector3fX16 own = Interpolate(b, detail::CornersOf(t, &TriangleMesh::s));
            s.dpdus = Select(LengthSquared(own) > 0, own, s.dpdu);
        }
        s.faceIndex = t.FaceIndices(met.hit.primitive);
    }
    return s;
}

/// BilinearSurface sixteen times; of planar meshes.
template <bool kWithTangents>
inline SurfaceInteractionX16 FlatPatchSurfaces(const PacketHits &met, LaneBits active) {
    const detail::PatchPacket lanes(met, active);
    const auto corners = [&](auto attribute) {
        return std::array{lanes.At(0, attribute), lanes.At(1, attribute), lanes.At(2, attribute),
                          lanes.At(3, attribute)};
    };
    const auto p = corners(&BilinearMesh::p);
    const PatchT<FloatX16> q{p[0], p[1], p[2], p[3]};
    const Point2fX16 patchUV = PatchFromLinear(q, met.hit.u, met.hit.v);
    const BilinearWeightsT<FloatX16> w(patchUV);
    const FlatHit<FloatX16> at(q, met.hit.u, met.hit.v);
    SurfaceInteractionX16 s;
    s.p = at.p;
    s.dpdu = q.DpDu(patchUV.y);
    s.dpdv = q.DpDv(patchUV.x);
    s.n = PatchNormal(q, s.dpdu, s.dpdv);
    s.pError = PatchError(q, w) + FlatPatchError(q, at, s.n);
    detail::SetNormals(
        lanes, lanes.Have(&BilinearMesh::n),
        [&] {
            const auto n = corners(&BilinearMesh::n);
            return w(n[0], n[1], n[2], n[3]);
        },
        &s);
    if constexpr (kWithTangents) {
        s.uv = patchUV;
        s.dpdus = s.dpdu;
        s.faceIndex = lanes.FaceIndices(met.hit.primitive);
        ForEachLane(lanes.Have(&BilinearMesh::uv) & active, [&](int i) {
            SurfaceInteraction one = Lane(s, i);
            SetPatchUV(*lanes.mesh[size_t(i)], lanes.index[size_t(i)], one.uv, &one);
            one.dpdus = one.dpdu;
            SetLane(&s, i, one);
        });
    }
    return s;
}

/// SphereSurface sixteen times, without tangents, uv and faceIndex.
inline SurfaceInteractionX16 SphereSurfaces(const PacketHits &met, LaneBits active) {
    MatrixX16 renderFromObject, objectFromRender;
    FloatX16 radius;
    LaneBits flipped = 0;
    const int first = std::countr_zero(active);
    for (int i = 0; i < kPacketSize; ++i) {
        const int from = active >> i & 1 ? i : first;
        const Sphere &sphere = *std::get_if<Sphere>(met.shape[size_t(from)]);
        for (size_t row = 0; row < 3; ++row)
            for (size_t k = 0; k < 4; ++k) {
                renderFromObject[row][k].Set(i, sphere.renderFromObject.Matrix()[row][k]);
                objectFromRender[row][k].Set(i, sphere.renderFromObject.InverseMatrix()[row][k]);
            }
        radius.Set(i, sphere.radius);
        flipped |= LaneBits(sphere.flipNormal) << i;
    }
    const Vec3<DoubleX16> p =
        OnSphere(ObjectPoint(objectFromRender, met.o, met.d, met.hit.t), radius);
    SurfaceInteractionX16 s;
    PlaceQuadric<true>(renderFromObject, objectFromRender, p, ToFloat(p), MaskOf(flipped), &s);
    return s;
}

namespace detail {

inline SurfaceInteraction SurfaceAtLane(const PacketHits &met, int i) {
    const HitPacket &h = met.hit;
    return SurfaceAt(*met.shape[size_t(i)],
                     {h.t[i], h.u[i], h.v[i], h.geometry[i], h.primitive[i], h.instance[i]},
                     {Lane(met.o, i), Lane(met.d, i)});
}
inline void Merge(LaneBits lanes, const SurfaceInteractionX16 &from, SurfaceInteractionX16 *to) {
    const MaskX16 mask = MaskOf(lanes);
    to->p = Select(mask, from.p, to->p);
    to->pError = Select(mask, from.pError, to->pError);
    to->n = Select(mask, from.n, to->n);
    to->ns = Select(mask, from.ns, to->ns);
    to->dpdu = Select(mask, from.dpdu, to->dpdu);
    to->dpdv = Select(mask, from.dpdv, to->dpdv);
    to->dpdus = Select(mask, from.dpdus, to->dpdus);
    to->uv = Select(mask, from.uv, to->uv);
    to->faceIndex = Select(mask, from.faceIndex, to->faceIndex);
}

}  // namespace detail

/// SurfaceAt for the active lanes; the others' shapes are not read and their results undefined.
/// kWithTangents: as above. Meshes of triangles and flat patches and, without tangents, spheres are
/// handled side by side, the rest one by one.
template <bool kWithTangents>
inline SurfaceInteractionX16 SurfacePacket(const PacketHits &met, LaneBits active) {
    LaneBits triangles = 0, patches = 0, spheres = 0;
    ForEachLane(active, [&](int i) {
        const Shape &shape = *met.shape[size_t(i)];
        const LaneBits bit = LaneBits(1) << i;
        if (std::holds_alternative<TriangleMesh>(shape))
            triangles |= bit;
        else if (const auto *mesh = std::get_if<BilinearMesh>(&shape); mesh && mesh->planar)
            patches |= bit;
        else if (!kWithTangents && std::holds_alternative<Sphere>(shape))
            spheres |= bit;
    });
    if (triangles == active && active) return TriangleSurfaces<kWithTangents>(met, active);
    SurfaceInteractionX16 s;
    LaneBits others = active;
    const auto together = [&](LaneBits lanes, auto interact) {
        if (std::popcount(lanes) < 3) return;  // one by one is faster
        detail::Merge(lanes, interact(met, lanes), &s);
        others &= ~lanes;
    };
    together(triangles, TriangleSurfaces<kWithTangents>);
    together(patches, FlatPatchSurfaces<kWithTangents>);
    together(spheres, SphereSurfaces);
    ForEachLane(others, [&](int i) { SetLane(&s, i, detail::SurfaceAtLane(met, i)); });
    return s;
}

}  // namespace pbrt
