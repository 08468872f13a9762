#pragma once

#include <algorithm>

#include "pbrt/util/transform.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

using Vector3d = Vec3<double>;

inline Vector3d ToDouble(Vector3f v) {
    return {v.x, v.y, v.z};
}
inline Vector3f ToFloat(Vector3d v) {
    return {float(v.x), float(v.y), float(v.z)};
}

/// m applied to a point without float rounding; m is affine.
inline Vector3d PointInDouble(const Matrix4 &m, Vector3d p) {
    return {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3],
            m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3],
            m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3]};
}

/// |m| applied to |p|: the size of what PointInDouble and Transform::Point sum up.
inline Vector3f AbsPoint(const Matrix4 &m, Point3f p) {
    const auto row = [&](int i) {
        return std::abs(m[i][0] * p.x) + std::abs(m[i][1] * p.y) + std::abs(m[i][2] * p.z) +
               std::abs(m[i][3]);
    };
    return {row(0), row(1), row(2)};
}
inline Vector3f AbsVector(const Matrix4 &m, Vector3f v) {
    const auto row = [&](int i) {
        return std::abs(m[i][0] * v.x) + std::abs(m[i][1] * v.y) + std::abs(m[i][2] * v.z);
    };
    return {row(0), row(1), row(2)};
}

/// A cross product's direction and the inverse of its length.
struct CrossDirection {
    Normal3f n;
    float inverseLength;
};

/// Where float over- or underflows: through double, and (0, 0, 1), 0 for parallel vectors.
[[gnu::cold]] CrossDirection CrossDirectionInDouble(Vector3f a, Vector3f b);

inline CrossDirection DirectionOfCross(Vector3f a, Vector3f b) {
    const Vector3f c = Cross(a, b);
    const float l2 = LengthSquared(c);
    if (!(l2 > 1e-30f && l2 < 1e30f)) [[unlikely]]
        return CrossDirectionInDouble(a, b);
    const float inverse = 1 / std::sqrt(l2);
    return {c * inverse, inverse};
}

/// Cross(a, b) normalised; (0, 0, 1) where the vectors are parallel.
inline Normal3f UnitCross(Vector3f a, Vector3f b) {
    return DirectionOfCross(a, b).n;
}

/// v normalised, or `other` where v has no direction.
inline Vector3f UnitOr(Vector3f v, Vector3f other) {
    const float l2 = LengthSquared(v);
    return l2 > 1e-30f && l2 < 1e30f ? v * (1 / std::sqrt(l2)) : other;
}

/// How far from a triangle's plane a ray's origin must be, per axis, for Embree's test in float to
/// get its side right: t has the sign of (p0 - o).Ng, Ng being the cross product of differences of
/// the corners relative to o. For o within the triangle, |corner - o| <= its extent E in each axis,
/// so the error is a number of roundings times |p0 - o| E E / |Ng|, summed over the axes. At worst
/// 24 of them (edges 3, products 7, difference 8, with p0 - o 10, sum 12, twice for two products);
/// 4e5 random rays need 1; 4 are taken, for slivers would be left too far behind.
/// e1, e2: edges at p0; p: a point of the plane.
inline Vector3f PlaneTestError(Point3f p, Point3f p0, Vector3f e1, Vector3f e2, Normal3f n,
                               float inverseLengthNg) {
    const Vector3f c = Abs(p0 - p), e = Max(Max(Abs(e1), Abs(e2)), Abs(e2 - e1));
    const Vector3f f = e * (Gamma(4) * inverseLengthNg);
    return Abs(n) * (c.x * f.y * e.z + c.y * f.z * e.x + c.z * f.x * e.y);
}

}  // namespace pbrt
