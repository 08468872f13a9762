#pragma once

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/surface_point.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

/// Sets dpdu and dpdv from edges and the differences of uv along them; any tangent frame where uv
/// are degenerate.
inline void SetTangents(Vector3f e1, Vector3f e2, Point2f duv1, Point2f duv2, SurfacePoint *s) {
    const float a = duv1.x * duv2.y, b = duv1.y * duv2.x, det = a - b;
    if (std::abs(det) > 1e-6f * (std::abs(a) + std::abs(b))) {
        const float inv = 1 / det;
        s->dpdu = (duv2.y * e1 - duv1.y * e2) * inv;
        s->dpdv = (duv1.x * e2 - duv2.x * e1) * inv;
        const float size = LengthSquared(s->dpdu) * LengthSquared(s->dpdv);
        if (size > 0 && size < Infinity) return;
    }
    const Frame frame = Frame::FromZ(s->n);
    s->dpdu = frame.x;
    s->dpdv = frame.y;
}

template <bool kWithError>
inline SurfacePoint InteractTriangle(const TriangleMesh &mesh, const Hit &hit) {
    const uint32_t *index = &mesh.indices[3 * size_t(hit.primitive)];
    const uint32_t i0 = index[0], i1 = index[1], i2 = index[2];
    const Point3f p0 = mesh.p[i0], p1 = mesh.p[i1], p2 = mesh.p[i2];
    const float b1 = hit.u, b2 = hit.v, b0 = 1 - b1 - b2;
    const Vector3f e1 = p1 - p0, e2 = p2 - p0;
    SurfacePoint s;
    s.p = b0 * p0 + b1 * p1 + b2 * p2;
    const CrossDirection up = DirectionOfCross(e1, e2);
    s.n = up.n;
    // Interpolation 5 roundings and 1 - b1 - b2 two more; the spawned origin's own rounding one.
    if constexpr (kWithError)
        s.pError = Gamma(8) * (Abs(b0 * p0) + Abs(b1 * p1) + Abs(b2 * p2)) +
                   PlaneTestError(s.p, p0, e1, e2, s.n, up.inverseLength);
    if (mesh.flipNormal) s.n = -s.n;
    s.ns = s.n;
    if (!mesh.n.empty()) {
        s.ns = UnitOr(b0 * mesh.n[i0] + b1 * mesh.n[i1] + b2 * mesh.n[i2], s.n);
        s.n = FaceForward(s.n, s.ns);
    }
    if (mesh.uv.empty()) {
        s.uv = {b1 + b2, b2};
        s.dpdu = e1;
        s.dpdv = p2 - p1;
    } else {
        const Point2f uv0 = mesh.uv[i0], uv1 = mesh.uv[i1], uv2 = mesh.uv[i2];
        s.uv = b0 * uv0 + b1 * uv1 + b2 * uv2;
        SetTangents(e1, e2, uv1 - uv0, uv2 - uv0, &s);
    }
    s.dpdus = s.dpdu;
    if (!mesh.s.empty()) {
        const Vector3f tangent = b0 * mesh.s[i0] + b1 * mesh.s[i1] + b2 * mesh.s[i2];
        if (LengthSquared(tangent) > 0) s.dpdus = tangent;
    }
    s.faceIndex = mesh.faceIndices.empty() ? int(hit.primitive) : mesh.faceIndices[hit.primitive];
    return s;
}

}  // namespace pbrt
