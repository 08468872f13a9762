#pragma once

#include <algorithm>

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/surface_point.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

/// The corners of one patch.
struct Patch {
    Point3f p00, p10, p01, p11;

    Vector3f DpDu(float v) const { return (1 - v) * (p10 - p00) + v * (p11 - p01); }
    Vector3f DpDv(float u) const { return (1 - u) * (p01 - p00) + u * (p11 - p10); }
};

/// Bilinear weights of corners 00 10 01 11.
struct BilinearWeights {
    float w00, w10, w01, w11;

    explicit BilinearWeights(Point2f uv)
        : w00((1 - uv.x) * (1 - uv.y)),
          w10(uv.x * (1 - uv.y)),
          w01((1 - uv.x) * uv.y),
          w11(uv.x * uv.y) {}
    template <typename T>
    T operator()(T a00, T a10, T a01, T a11) const {
        return w00 * a00 + w10 * a10 + w01 * a01 + w11 * a11;
    }
    Point3f operator()(const Patch &q) const { return (*this)(q.p00, q.p10, q.p01, q.p11); }
};

inline const uint32_t *PatchIndices(const BilinearMesh &mesh, uint32_t primitive) {
    return &mesh.indices[4 * size_t(primitive)];
}
inline Patch GetPatch(const BilinearMesh &mesh, uint32_t primitive) {
    const uint32_t *i = PatchIndices(mesh, primitive);
    return {mesh.p[i[0]], mesh.p[i[1]], mesh.p[i[2]], mesh.p[i[3]]};
}

/// p11 of a flat patch in the basis (p10 - p00, p01 - p00) at p00; (1, 1) for parallelograms.
inline Point2f FarCorner(const Patch &q) {
    const Vector3f e1 = q.p10 - q.p00, e2 = q.p01 - q.p00, d = q.p11 - q.p00;
    const Vector3f n = Cross(e1, e2);
    const float inv = 1 / LengthSquared(n);
    return {Dot(Cross(d, e2), n) * inv, Dot(Cross(e1, d), n) * inv};
}

/// The patch coordinates of a flat, convex patch from those linear in each of its triangles
/// (BilinearMesh::planar). With far corner (1 + A, 1 + B): a = u (1 + A v), b = v (1 + B u).
inline Point2f PatchFromLinear(const Patch &q, float u, float v) {
    const Vector3f skew = (q.p11 - q.p10) - (q.p01 - q.p00);
    const Vector3f d = q.p11 - q.p00;
    if (LengthSquared(skew) <= 1e-12f * LengthSquared(d)) return {u, v};
    const Point2f corner = FarCorner(q);
    const float A = corner.x - 1, B = corner.y - 1;
    const bool near = u + v <= 1;
    const float a = near ? u : u * corner.x - (1 - v) * A;
    const float b = near ? v : v * corner.y - (1 - u) * B;
    // A v^2 + v (1 + B a - A b) - b = 0, the root that stays finite as A goes to 0.
    const float half = 1 + B * a - A * b;
    const float newV = 2 * b / (half + SafeSqrt(half * half + 4 * A * b));
    return {std::clamp(a / (1 + A * newV), 0.f, 1.f), std::clamp(newV, 0.f, 1.f)};
}

/// Unit normal of cross(dpdu, dpdv); at a collapsed corner the patch's overall one.
inline Normal3f PatchNormal(const Patch &q, Vector3f dpdu, Vector3f dpdv) {
    const float l2 = LengthSquared(Cross(dpdu, dpdv));
    const float size2 = LengthSquared(dpdu) * LengthSquared(dpdv);
    if (l2 > 1e-10f * size2 && l2 > 0) return UnitCross(dpdu, dpdv);
    return UnitCross(q.p11 - q.p00, q.p01 - q.p10);
}

/// uv of the mesh, and tangents with respect to them where they are given.
inline void SetPatchUV(const BilinearMesh &mesh, const uint32_t *i, Point2f patchUV,
                       SurfacePoint *s) {
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

/// Position error of a hit: 7 roundings of the bilinear sum and one of the spawned origin; flat
/// patches also carry Embree's test of one of their triangles.
inline Vector3f PatchError(const BilinearMesh &mesh, const Patch &q, const Hit &hit,
                           const BilinearWeights &w, const SurfacePoint &s) {
    const Vector3f sum = BilinearWeights(w)(Abs(q.p00), Abs(q.p10), Abs(q.p01), Abs(q.p11));
    Vector3f error = Gamma(9) * sum;
    if (!mesh.planar) return error;
    const bool near = hit.u + hit.v <= 1;
    const Point3f corner = near ? q.p00 : q.p11;
    const Vector3f e1 = q.p10 - corner, e2 = q.p01 - corner;
    return error + PlaneTestError(s.p, corner, e1, e2, s.n, DirectionOfCross(e1, e2).inverseLength);
}

template <bool kWithError>
inline SurfacePoint InteractBilinear(const BilinearMesh &mesh, const Hit &hit) {
    const uint32_t *i = PatchIndices(mesh, hit.primitive);
    const Patch q = GetPatch(mesh, hit.primitive);
    const Point2f uv = mesh.planar ? PatchFromLinear(q, hit.u, hit.v) : Point2f{hit.u, hit.v};
    const BilinearWeights w(uv);
    SurfacePoint s;
    if (!mesh.planar)
        s.p = w(q);
    else if (hit.u + hit.v <= 1)
        s.p = (1 - hit.u - hit.v) * q.p00 + hit.u * q.p10 + hit.v * q.p01;
    else
        s.p = (hit.u + hit.v - 1) * q.p11 + (1 - hit.u) * q.p01 + (1 - hit.v) * q.p10;
    s.dpdu = q.DpDu(uv.y);
    s.dpdv = q.DpDv(uv.x);
    s.n = PatchNormal(q, s.dpdu, s.dpdv);
    if constexpr (kWithError) s.pError = PatchError(mesh, q, hit, w, s);
    if (mesh.flipNormal) s.n = -s.n;
    s.ns = s.n;
    if (!mesh.n.empty()) {
        s.ns = UnitOr(w(mesh.n[i[0]], mesh.n[i[1]], mesh.n[i[2]], mesh.n[i[3]]), s.n);
        s.n = FaceForward(s.n, s.ns);
    }
    SetPatchUV(mesh, i, uv, &s);
    s.dpdus = s.dpdu;
    s.faceIndex = mesh.faceIndices.empty() ? int(hit.primitive) : mesh.faceIndices[hit.primitive];
    return s;
}

}  // namespace pbrt
