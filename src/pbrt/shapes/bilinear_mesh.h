#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/mesh_packet.h"
#include "pbrt/shapes/patch.h"

namespace pbrt {

/// `Shape "bilinearmesh"`, and the quads of PLY files: p(u,v) of corners 00 10 01 11.
struct BilinearMesh {
    static constexpr std::string_view kName = "bilinearmesh";
    static constexpr ShapeTraits kTraits{
        .canEmit = true, .intersectsItself = true, .fewestWide = 3};
    static constexpr std::array<std::string_view, 5> kExamples{
        R"("point3 P" [ 0 0 0  2 0 0  0 1 0  2 1 0 ])",
        R"("point3 P" [ 0 0 0  2 0 0  1 1 0  3 1 0 ])",
        R"("point3 P" [ 0 0 0  2 0 0  0 1 0  1 2 0 ])",
        R"("point3 P" [ 0 0 0  2 0 0  0 1 0  2 2 1 ])",
        R"("point3 P" [ 0 0 0  2 0 0  0 1 0  2 1 0 ] "point2 uv" [ 0 0  0 3  3 0  3 3 ]
            "normal N" [ 0 0 1  0 0.2 1  0 0 1  0.1 0 1 ] "integer faceIndices" 5)"};
    static std::optional<BilinearMesh> Create(const ShapeArguments &a);

    size_t NPrimitives() const { return indices.size() / 4; }
    Bounds3f Bounds() const;
    Bounds3f PrimitiveBounds(uint32_t primitive) const;

    template <bool kWithError>
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;
    template <bool kWithTangents>
    bool IsWide() const {
        return planar;
    }
    template <bool kWithTangents>
    static SurfaceInteractionX16 SurfacesAt(const ShapePacket<BilinearMesh> &meshes,
                                            const RayHits &met, LaneBits active);

    /// Intersection with the bilinear surface, for the ray tracer where the mesh is not planar.
    std::optional<PrimitiveHit> Intersect(uint32_t primitive, const RayD &ray) const;

    // Rectangles by solid angle: patch_sampler.h.
    float Area(uint32_t primitive) const;
    std::optional<ShapeSample> SampleArea(uint32_t primitive, Point2f u) const;
    std::optional<ShapeSample> SampleFrom(uint32_t primitive, Point3f ref, Point2f u) const;
    float PDFFrom(uint32_t primitive, Point3f ref, Point3f p, Normal3f n) const;
    NormalCone NormalBounds(uint32_t primitive) const;

    std::vector<uint32_t> indices;  ///< 4 a patch
    std::vector<Point3f> p;         ///< this and the rest: as in TriangleMesh
    std::vector<Normal3f> n;
    std::vector<Point2f> uv;
    std::vector<int> faceIndices;
    bool flipNormal = false;
    /// Every patch is flat and convex (IsPlanar): traversal takes it as two triangles, and a hit's
    /// (u, v) are linear in each: p00 + u (p10 - p00) + v (p01 - p00) where u + v <= 1, else
    /// p11 + (1 - u) (p01 - p11) + (1 - v) (p10 - p11).
    bool planar = false;
};

inline const uint32_t *PatchIndices(const BilinearMesh &mesh, uint32_t primitive) {
    return &mesh.indices[4 * size_t(primitive)];
}
inline Patch GetPatch(const BilinearMesh &mesh, uint32_t primitive) {
    const uint32_t *i = PatchIndices(mesh, primitive);
    return {mesh.p[i[0]], mesh.p[i[1]], mesh.p[i[2]], mesh.p[i[3]]};
}

/// uv of the mesh, and tangents with respect to them where they are given.
inline void SetPatchUV(const BilinearMesh &mesh, const uint32_t *i, Point2f patchUV,
                       SurfaceInteraction *s) {
    s->uv = patchUV;
    if (mesh.uv.empty()) return;
    const Point2f uv00 = mesh.uv[i[0]], uv10 = mesh.uv[i[1]], uv01 = mesh.uv[i[2]],
                  uv11 = mesh.uv[i[3]];
    s->uv = BilinearWeights(patchUV)(uv00, uv10, uv01, uv11);
    const Vector2f du = (1 - patchUV.y) * (uv10 - uv00) + patchUV.y * (uv11 - uv01);
    const Vector2f dv = (1 - patchUV.x) * (uv01 - uv00) + patchUV.x * (uv11 - uv10);
    const float a = du.x * dv.y, b = du.y * dv.x, det = a - b;
    if (!(std::abs(det) > 1e-6f * (std::abs(a) + std::abs(b)))) return;
    const float inv = 1 / det;
    const Vector3f dpdu = s->dpdu, dpdv = s->dpdv;
    s->dpdu = (dv.y * dpdu - du.y * dpdv) * inv;
    s->dpdv = (du.x * dpdv - dv.x * dpdu) * inv;
}

template <bool kWithError>
inline SurfaceInteraction BilinearMesh::SurfaceAt(const Hit &hit, const Ray &) const {
    const BilinearMesh &mesh = *this;
    const uint32_t *i = PatchIndices(mesh, hit.primitive);
    const Patch q = GetPatch(mesh, hit.primitive);
    const Point2f patchUV = mesh.planar ? PatchFromLinear(q, hit.u, hit.v) : Point2f{hit.u, hit.v};
    const BilinearWeights w(patchUV);
    SurfaceInteraction s;
    s.dpdu = q.DpDu(patchUV.y);
    s.dpdv = q.DpDv(patchUV.x);
    s.n = PatchNormal(q, s.dpdu, s.dpdv);
    if constexpr (kWithError) s.pError = PatchError(q, w);
    if (mesh.planar) {
        const FlatHit<float> at(q, hit.u, hit.v);
        s.p = at.p;
        if constexpr (kWithError) s.pError = s.pError + FlatPatchError(q, at, s.n);
    } else {
        s.p = w(q);
    }
    if (mesh.flipNormal) s.n = -s.n;
    s.ns = s.n;
    if (!mesh.n.empty()) {
        s.ns = UnitOr(w(mesh.n[i[0]], mesh.n[i[1]], mesh.n[i[2]], mesh.n[i[3]]), s.n);
        s.n = FaceForward(s.n, s.ns);
    }
    SetPatchUV(mesh, i, patchUV, &s);
    s.dpdus = s.dpdu;
    s.faceIndex = mesh.faceIndices.empty() ? int(hit.primitive) : mesh.faceIndices[hit.primitive];
    return s;
}

template <bool kWithTangents>
inline SurfaceInteractionX16 BilinearMesh::SurfacesAt(const ShapePacket<BilinearMesh> &meshes,
                                                      const RayHits &met, LaneBits active) {
    const detail::MeshPacket<BilinearMesh, 4> lanes(meshes, met.hit.primitive, active);
    const auto corners = [&](auto attribute) {
        return std::array{lanes.At(0, attribute), lanes.At(1, attribute), lanes.At(2, attribute),
                          lanes.At(3, attribute)};
    };
    const auto at4 = corners(&BilinearMesh::p);
    const PatchT<FloatX16> q{at4[0], at4[1], at4[2], at4[3]};
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
            const auto normals = corners(&BilinearMesh::n);
            return w(normals[0], normals[1], normals[2], normals[3]);
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

}  // namespace pbrt
