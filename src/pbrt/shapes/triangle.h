#pragma once

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/surface_interaction.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

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
inline SurfaceInteraction TriangleSurface(const TriangleMesh &mesh, const Hit &hit) {
    const uint32_t *index = &mesh.indices[3 * size_t(hit.primitive)];
    const auto at = [&](const auto &values) {
        return Corners<std::decay_t<decltype(values[0])>>{values[index[0]], values[index[1]],
                                                          values[index[2]]};
    };
    const Corners<Point3f> p = at(mesh.p);
    const Corners<float> b{1 - hit.u - hit.v, hit.u, hit.v};
    SurfaceInteraction s;
    PlaceOnTriangle<kWithError>(p, b, &s);
    if (mesh.flipNormal) s.n = s.ns = -s.n;
    if (!mesh.n.empty()) {
        s.ns = UnitOr(Interpolate(b, at(mesh.n)), s.n);
        s.n = FaceForward(s.n, s.ns);
    }
    const Vector3f e1 = p.v1 - p.v0, e2 = p.v2 - p.v0;
    if (mesh.uv.empty()) {
        s.uv = {b.v1 + b.v2, b.v2};
        s.dpdu = e1;
        s.dpdv = p.v2 - p.v1;
    } else {
        const Corners<Point2f> uv = at(mesh.uv);
        s.uv = Interpolate(b, uv);
        SetTangents(e1, e2, uv.v1 - uv.v0, uv.v2 - uv.v0, &s);
    }
    s.dpdus = s.dpdu;
    if (!mesh.s.empty()) {
        const Vector3f tangent = Interpolate(b, at(mesh.s));
        if (LengthSquared(tangent) > 0) s.dpdus = tangent;
    }
    s.faceIndex = mesh.faceIndices.empty() ? int(hit.primitive) : mesh.faceIndices[hit.primitive];
    return s;
}

}  // namespace pbrt
