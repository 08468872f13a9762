#pragma once

#include <algorithm>

#include "pbrt/shapes/rounding.h"

namespace pbrt {

// Mathematics of one bilinear patch. T: float or FloatX16.

/// The corners of one patch.
template <typename T>
struct PatchT {
    Vec3<T> p00, p10, p01, p11;

    Vec3<T> DpDu(T v) const { return (1 - v) * (p10 - p00) + v * (p11 - p01); }
    Vec3<T> DpDv(T u) const { return (1 - u) * (p01 - p00) + u * (p11 - p10); }
};
using Patch = PatchT<float>;

/// Bilinear weights of corners 00 10 01 11.
template <typename T>
struct BilinearWeightsT {
    T w00, w10, w01, w11;

    explicit BilinearWeightsT(Vec2<T> uv)
        : w00((1 - uv.x) * (1 - uv.y)),
          w10(uv.x * (1 - uv.y)),
          w01((1 - uv.x) * uv.y),
          w11(uv.x * uv.y) {}
    template <typename V>
    V operator()(V a00, V a10, V a01, V a11) const {
        return w00 * a00 + w10 * a10 + w01 * a01 + w11 * a11;
    }
    Vec3<T> operator()(const PatchT<T> &q) const { return (*this)(q.p00, q.p10, q.p01, q.p11); }
};
using BilinearWeights = BilinearWeightsT<float>;

/// p11 of a flat patch in the basis (p10 - p00, p01 - p00) at p00; (1, 1) for parallelograms.
template <typename T>
inline Vec2<T> FarCorner(const PatchT<T> &q) {
    const Vec3<T> e1 = q.p10 - q.p00, e2 = q.p01 - q.p00, d = q.p11 - q.p00;
    const Vec3<T> n = Cross(e1, e2);
    const T inv = 1 / LengthSquared(n);
    return {Dot(Cross(d, e2), n) * inv, Dot(Cross(e1, d), n) * inv};
}

/// The patch coordinates of a flat, convex patch from those linear in each of its triangles
/// (BilinearMesh::planar). With far corner (1 + A, 1 + B): a = u (1 + A v), b = v (1 + B u).
template <typename T>
inline Vec2<T> PatchFromLinear(const PatchT<T> &q, T u, T v) {
    const Vec3<T> skew = (q.p11 - q.p10) - (q.p01 - q.p00);
    const Vec3<T> d = q.p11 - q.p00;
    const auto straight = LengthSquared(skew) <= 1e-12f * LengthSquared(d);
    if (All(straight)) [[likely]]
        return {u, v};
    const Vec2<T> corner = FarCorner(q);
    const T A = corner.x - 1, B = corner.y - 1;
    const auto near = u + v <= 1;
    const T a = Select(near, u, u * corner.x - (1 - v) * A);
    const T b = Select(near, v, v * corner.y - (1 - u) * B);
    // A v^2 + v (1 + B a - A b) - b = 0, the root that stays finite as A goes to 0.
    const T half = 1 + B * a - A * b;
    const T newV = 2 * b / (half + SafeSqrt(half * half + 4 * A * b));
    return {Select(straight, u, Clamp(a / (1 + A * newV), 0.f, 1.f)),
            Select(straight, v, Clamp(newV, 0.f, 1.f))};
}

/// Unit normal of cross(dpdu, dpdv); at a collapsed corner the patch's overall one.
template <typename T>
inline Vec3<T> PatchNormal(const PatchT<T> &q, Vec3<T> dpdu, Vec3<T> dpdv) {
    const T l2 = LengthSquared(Cross(dpdu, dpdv));
    const T size2 = LengthSquared(dpdu) * LengthSquared(dpdv);
    const auto good = (l2 > 1e-10f * size2) & (l2 > 0);
    if (All(good)) [[likely]]
        return UnitCross(dpdu, dpdv);
    return UnitCross(Select(good, dpdu, q.p11 - q.p00), Select(good, dpdv, q.p01 - q.p10));
}

/// A hit of a flat patch: its place from the nearer of the two triangles' corners (see
/// BilinearMesh::planar).
template <typename T>
struct FlatHit {
    MaskFor<T> near;
    Vec3<T> corner, p;

    FlatHit(const PatchT<T> &q, T u, T v)
        : near(u + v <= 1),
          corner(Select(near, q.p00, q.p11)),
          p(Select(near, T(1 - u - v) * q.p00 + u * q.p10 + v * q.p01,
                   T(u + v - 1) * q.p11 + T(1 - u) * q.p01 + T(1 - v) * q.p10)) {}
};

/// Position error of a hit: 7 roundings of the bilinear sum and one of the spawned origin.
template <typename T>
inline Vec3<T> PatchError(const PatchT<T> &q, const BilinearWeightsT<T> &w) {
    return Gamma(9) * w(Abs(q.p00), Abs(q.p10), Abs(q.p01), Abs(q.p11));
}
/// Further error of flat patches: that of the ray tracer's test of one of their triangles.
template <typename T>
inline Vec3<T> FlatPatchError(const PatchT<T> &q, const FlatHit<T> &at, Vec3<T> n) {
    const Vec3<T> e1 = q.p10 - at.corner, e2 = q.p01 - at.corner;
    return PlaneTestError(at.p, at.corner, e1, e2, n, DirectionOfCross(e1, e2).inverseLength);
}

}  // namespace pbrt
