#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/mesh_packet.h"
#include "pbrt/shapes/rounding.h"

namespace pbrt {

/// `Shape "trianglemesh"`, and what PLY files, ribbons and loops of other makers become.
struct TriangleMesh {
    static constexpr std::string_view kName = "trianglemesh";
    static constexpr ShapeTraits kTraits{.canEmit = true, .fewestWide = 1};
    static constexpr std::array<std::string_view, 2> kExamples{
        R"("point3 P" [ 0 0 0  2 0 0.5  0.3 1 0 ])",
        R"("integer indices" [ 0 1 2  0 2 3 ]
            "point3 P" [ 0 0 0  2 0 0  2 1 1  0 1 0 ] "point2 uv" [ 0 0  1 0  1 1  0 1 ]
            "normal N" [ 0 0 1  0 0.2 1  0 0 1  0.1 0 1 ] "integer faceIndices" [ 7 3 ])"};
    static std::optional<TriangleMesh> Create(const ShapeArguments &a);

    size_t NPrimitives() const { return indices.size() / 3; }
    Bounds3f Bounds() const;
    Bounds3f PrimitiveBounds(uint32_t primitive) const;

    template <bool kWithError>
    SurfaceInteraction SurfaceAt(const Hit &hit, const Ray &ray) const;
    template <bool kWithTangents>
    bool IsWide() const {
        return true;
    }
    template <bool kWithTangents>
    static SurfaceInteractionX16 SurfacesAt(const ShapePacket<TriangleMesh> &meshes,
                                            const RayHits &met, LaneBits active);

    // By the triangle's solid angle where it is neither tiny nor huge: triangle_sampler.h.
    float Area(uint32_t primitive) const;
    std::optional<ShapeSample> SampleArea(uint32_t primitive, Point2f u) const;
    std::optional<ShapeSample> SampleFrom(uint32_t primitive, Point3f ref, Point2f u) const;
    float PDFFrom(uint32_t primitive, Point3f ref, Point3f p, Normal3f n) const;
    NormalCone NormalBounds(uint32_t primitive) const;

    std::vector<uint32_t> indices;  ///< 3 a triangle
    std::vector<Point3f> p;         ///< rendering space (object's space of an instance)
    std::vector<Normal3f> n;        ///< per vertex, or empty
    std::vector<Vector3f> s;        ///< per vertex tangents, or empty
    std::vector<Point2f> uv;        ///< per vertex, or empty: (0,0) (1,0) (1,1)
    std::vector<int> faceIndices;   ///< per triangle, or empty: the triangle's number
    bool flipNormal = false;        ///< ReverseOrientation xor left-handed transform
};

/// Sets dpdu and dpdv from edges and the differences of uv along them; any tangent frame where uv
/// are degenerate.
template <typename T>
inline void SetTangents(Vec3<T> e1, Vec3<T> e2, Vec2<T> duv1, Vec2<T> duv2,
                        SurfaceInteractionT<T> *s) {
    const T a = duv1.x * duv2.y, b = duv1.y * duv2.x, det = a - b;
    const T inv = 1 / det;
    s->dpdu = (duv2.y * e1 - duv1.y * e2) * inv;
    s->dpdv = (duv1.x * e2 - duv2.x * e1) * inv;
    const T size = LengthSquared(s->dpdu) * LengthSquared(s->dpdv);
    const auto good = (Abs(det) > 1e-6f * (Abs(a) + Abs(b))) & (size > 0) & (size < Infinity);
    if (All(good)) [[likely]]
        return;
    const FrameT<T> frame = FrameT<T>::FromZ(s->n);
    s->dpdu = Select(good, s->dpdu, frame.x);
    s->dpdv = Select(good, s->dpdv, frame.y);
}

/// Three of something: one per corner, or weights of them.
template <typename V>
struct Corners {
    V v0, v1, v2;
};

template <typename T, typename V>
inline V Interpolate(const Corners<T> &b, const Corners<V> &a) {
    return b.v0 * a.v0 + b.v1 * a.v1 + b.v2 * a.v2;
}

/// Position and true normal, outside as the corners' order says.
template <bool kWithError, typename T>
inline void PlaceOnTriangle(const Corners<Vec3<T>> &p, const Corners<T> &b,
                            SurfaceInteractionT<T> *s) {
    const Vec3<T> e1 = p.v1 - p.v0, e2 = p.v2 - p.v0;
    s->p = Interpolate(b, p);
    const CrossDirectionT<T> up = DirectionOfCross(e1, e2);
    s->n = s->ns = up.n;
    // Interpolation 5 roundings and 1 - b1 - b2 two more; the spawned origin's own rounding one.
    if constexpr (kWithError)
        s->pError = Gamma(8) * (Abs(b.v0 * p.v0) + Abs(b.v1 * p.v1) + Abs(b.v2 * p.v2)) +
                    PlaneTestError(s->p, p.v0, e1, e2, s->n, up.inverseLength);
}

template <bool kWithError>
inline SurfaceInteraction TriangleMesh::SurfaceAt(const Hit &hit, const Ray &) const {
    const uint32_t *index = &indices[3 * size_t(hit.primitive)];
    const auto at = [&](const auto &values) {
        return Corners<std::decay_t<decltype(values[0])>>{values[index[0]], values[index[1]],
                                                          values[index[2]]};
    };
    const Corners<Point3f> corners = at(p);
    const Corners<float> b{1 - hit.u - hit.v, hit.u, hit.v};
    SurfaceInteraction surface;
    PlaceOnTriangle<kWithError>(corners, b, &surface);
    if (flipNormal) surface.n = surface.ns = -surface.n;
    if (!n.empty()) {
        surface.ns = UnitOr(Interpolate(b, at(n)), surface.n);
        surface.n = FaceForward(surface.n, surface.ns);
    }
    const Vector3f e1 = corners.v1 - corners.v0, e2 = corners.v2 - corners.v0;
    if (uv.empty()) {
        surface.uv = {b.v1 + b.v2, b.v2};
        surface.dpdu = e1;
        surface.dpdv = corners.v2 - corners.v1;
    } else {
        const Corners<Point2f> texture = at(uv);
        surface.uv = Interpolate(b, texture);
        SetTangents(e1, e2, texture.v1 - texture.v0, texture.v2 - texture.v0, &surface);
    }
    surface.dpdus = surface.dpdu;
    if (!s.empty()) {
        const Vector3f tangent = Interpolate(b, at(s));
        if (LengthSquared(tangent) > 0) surface.dpdus = tangent;
    }
    surface.faceIndex = faceIndices.empty() ? int(hit.primitive) : faceIndices[hit.primitive];
    return surface;
}

namespace detail {

using TriangleLanes = MeshPacket<TriangleMesh, 3>;

template <typename V>
auto CornersOf(const TriangleLanes &t, std::vector<V> TriangleMesh::*attribute) {
    return Corners<decltype(t.At(0, attribute))>{t.At(0, attribute), t.At(1, attribute),
                                                 t.At(2, attribute)};
}

}  // namespace detail

template <bool kWithTangents>
inline SurfaceInteractionX16 TriangleMesh::SurfacesAt(const ShapePacket<TriangleMesh> &meshes,
                                                      const RayHits &met, LaneBits active) {
    const detail::TriangleLanes t(meshes, met.hit.primitive, active);
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

}  // namespace pbrt
