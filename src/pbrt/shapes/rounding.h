#pragma once

#include <algorithm>

#include "pbrt/util/transform.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

inline double ToDouble(float a) {
    return a;
}
inline DoubleX16 ToDouble(const FloatX16 &a) {
    return Convert<double>(a);
}
inline float ToFloat(double a) {
    return float(a);
}
inline FloatX16 ToFloat(const DoubleX16 &a) {
    return Convert<float>(a);
}
template <typename T>
inline auto ToDouble(const Vec3<T> &v) {
    return Vec3<decltype(ToDouble(v.x))>{ToDouble(v.x), ToDouble(v.y), ToDouble(v.z)};
}
template <typename D>
inline auto ToFloat(const Vec3<D> &v) {
    return Vec3<decltype(ToFloat(v.x))>{ToFloat(v.x), ToFloat(v.y), ToFloat(v.z)};
}

/// The upper rows of sixteen matrices.
using MatrixX16 = std::array<std::array<FloatX16, 4>, 3>;

// M: Matrix4 or MatrixX16.

/// m applied to a point without float rounding; m is affine.
template <typename M, typename D>
inline Vec3<D> PointInDouble(const M &m, const Vec3<D> &p) {
    const auto row = [&](size_t i) {
        return ToDouble(m[i][0]) * p.x + ToDouble(m[i][1]) * p.y + ToDouble(m[i][2]) * p.z +
               ToDouble(m[i][3]);
    };
    return {row(0), row(1), row(2)};
}

/// |m| applied to |p|: the size of what PointInDouble and Transform::Point sum up.
template <typename M, typename T>
inline Vec3<T> AbsPoint(const M &m, Vec3<T> p) {
    const auto row = [&](size_t i) {
        return Abs(m[i][0] * p.x) + Abs(m[i][1] * p.y) + Abs(m[i][2] * p.z) + Abs(m[i][3]);
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
template <typename T>
struct CrossDirectionT {
    Vec3<T> n;
    T inverseLength;
};
using CrossDirection = CrossDirectionT<float>;

/// For where float over- or underflows: through double, and (0, 0, 1), 0 for parallel vectors.
[[gnu::cold]] CrossDirection CrossDirectionInDouble(Vector3f a, Vector3f b);

[[gnu::cold]] CrossDirectionT<FloatX16> CrossDirectionInDouble(Vector3fX16 a, Vector3fX16 b);

/// True where a squared length neither over- nor underflows.
template <typename T>
inline auto IsSafe(T length2) {
    return (length2 > 1e-30f) & (length2 < 1e30f);
}

template <typename T>
inline CrossDirectionT<T> DirectionOfCross(Vec3<T> a, Vec3<T> b) {
    const Vec3<T> c = Cross(a, b);
    const T l2 = LengthSquared(c);
    if (!All(IsSafe(l2))) [[unlikely]]
        return CrossDirectionInDouble(a, b);
    const T inverse = 1 / Sqrt(l2);
    return {c * inverse, inverse};
}

/// Cross(a, b) normalised; (0, 0, 1) where the vectors are parallel.
template <typename T>
inline Vec3<T> UnitCross(Vec3<T> a, Vec3<T> b) {
    return DirectionOfCross(a, b).n;
}

/// v normalised, or `other` where v has no direction.
template <typename T>
inline Vec3<T> UnitOr(Vec3<T> v, Vec3<T> other) {
    const T l2 = LengthSquared(v);
    return Select(IsSafe(l2), v * (1 / Sqrt(l2)), other);
}

/// How far from a triangle's plane a ray's origin must be, per axis, for the ray tracer's test in
/// float to get its side right: t has the sign of (p0 - o).Ng, Ng being the cross product of
/// differences of the corners relative to o. For o within the triangle, |corner - o| <= its extent
/// E in each axis, so the error is a number of roundings times |p0 - o| E E / |Ng|, summed over the
/// axes. At worst 24 of them (edges 3, products 7, difference 8, with p0 - o 10, sum 12, twice for
/// two products); 4e5 random rays need 1; 4 are taken, for slivers would be left too far behind.
/// e1, e2: edges at p0; p: a point of the plane.
template <typename T>
inline Vec3<T> PlaneTestError(Vec3<T> p, Vec3<T> p0, Vec3<T> e1, Vec3<T> e2, Vec3<T> n,
                              T inverseLengthNg) {
    const Vec3<T> c = Abs(p0 - p), e = Max(Max(Abs(e1), Abs(e2)), Abs(e2 - e1));
    const Vec3<T> f = e * (Gamma(4) * inverseLengthNg);
    return Abs(n) * (c.x * f.y * e.z + c.y * f.z * e.x + c.z * f.x * e.y);
}

}  // namespace pbrt
