#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "pbrt/simd/math.h"

namespace pbrt {

inline constexpr float Pi = 3.14159265358979323846f;
inline constexpr float InvPi = 0.31830988618379067154f;
inline constexpr float Infinity = std::numeric_limits<float>::infinity();
/// Largest float below 1: upper end of every random number.
inline constexpr float OneMinusEpsilon = 0x1.fffffep-1f;

inline constexpr float Radians(float deg) {
    return deg * (Pi / 180);
}
template <typename T>
constexpr T Sqr(T x) {
    return x * x;
}
template <typename T, typename U>
constexpr auto Lerp(U t, T a, T b) {
    return (1 - t) * a + t * b;
}
/// Relative rounding error of n operations.
inline constexpr float Gamma(int n) {
    return n * (0x1p-24f) / (1 - n * 0x1p-24f);
}

template <typename T>
struct Vec2 {
    T x{}, y{};
    constexpr T operator[](int i) const { return i == 0 ? x : y; }
    constexpr T &operator[](int i) { return i == 0 ? x : y; }
    constexpr bool operator==(const Vec2 &) const = default;
};

/// Points, vectors and normals share one type; the aliases below say which is meant.
template <typename T>
struct Vec3 {
    T x{}, y{}, z{};
    constexpr T operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
    constexpr T &operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
    constexpr bool operator==(const Vec3 &) const = default;
};

using Point2f = Vec2<float>;
using Vector2f = Vec2<float>;
using Point2i = Vec2<int>;
using Vector3f = Vec3<float>;
using Point3f = Vec3<float>;
using Normal3f = Vec3<float>;

template <typename T>
constexpr Vec2<T> operator+(Vec2<T> a, Vec2<T> b) {
    return {a.x + b.x, a.y + b.y};
}
template <typename T>
constexpr Vec2<T> operator-(Vec2<T> a, Vec2<T> b) {
    return {a.x - b.x, a.y - b.y};
}
template <typename T>
constexpr Vec2<T> operator*(T s, Vec2<T> a) {
    return {s * a.x, s * a.y};
}
template <typename T>
constexpr Vec2<T> operator*(Vec2<T> a, T s) {
    return {s * a.x, s * a.y};
}

template <typename T>
constexpr Vec3<T> operator+(Vec3<T> a, Vec3<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename T>
constexpr Vec3<T> operator-(Vec3<T> a, Vec3<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename T>
constexpr Vec3<T> operator-(Vec3<T> a) {
    return {-a.x, -a.y, -a.z};
}
template <typename T>
constexpr Vec3<T> operator*(T s, Vec3<T> a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <typename T>
constexpr Vec3<T> operator*(Vec3<T> a, T s) {
    return {s * a.x, s * a.y, s * a.z};
}
template <typename T>
constexpr Vec3<T> operator/(Vec3<T> a, T s) {
    return a * (T(1) / s);
}
template <typename T>
constexpr Vec3<T> &operator+=(Vec3<T> &a, Vec3<T> b) {
    return a = a + b;
}

template <typename T>
constexpr T Dot(Vec3<T> a, Vec3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
T AbsDot(Vec3<T> a, Vec3<T> b) {
    return Abs(Dot(a, b));
}
template <typename T>
constexpr Vec3<T> Cross(Vec3<T> a, Vec3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename T>
constexpr T LengthSquared(Vec3<T> a) {
    return Dot(a, a);
}
template <typename T>
T Length(Vec3<T> a) {
    return Sqrt(Dot(a, a));
}
template <typename T>
Vec3<T> Normalize(Vec3<T> a) {
    return a * (T(1) / Length(a));
}
template <typename T>
Vec3<T> Abs(Vec3<T> a) {
    return {Abs(a.x), Abs(a.y), Abs(a.z)};
}
template <typename T>
constexpr T MaxComponent(Vec3<T> a) {
    return std::max(a.x, std::max(a.y, a.z));
}
template <typename T>
constexpr Vec3<T> Min(Vec3<T> a, Vec3<T> b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <typename T>
constexpr Vec3<T> Max(Vec3<T> a, Vec3<T> b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
/// n, turned round where needed so that it lies in v's hemisphere.
inline Normal3f FaceForward(Normal3f n, Vector3f v) {
    return Dot(n, v) < 0 ? -n : n;
}
inline float DistanceSquared(Point3f a, Point3f b) {
    return LengthSquared(a - b);
}

/// Angle between unit vectors in radians, accurate near 0 and pi (Kahan's half-angle form).
inline float AngleBetween(Vector3f a, Vector3f b) {
    return 2 * std::atan2(Length(a - b), Length(a + b));
}

struct Bounds3f {
    Point3f min{Infinity, Infinity, Infinity}, max{-Infinity, -Infinity, -Infinity};
    void Grow(Point3f p) { min = Min(min, p), max = Max(max, p); }
    void Grow(const Bounds3f &b) { min = Min(min, b.min), max = Max(max, b.max); }
    bool Empty() const { return min.x > max.x; }
    Point3f Center() const { return 0.5f * (min + max); }
    Vector3f Diagonal() const { return max - min; }
};

struct Ray {
    Point3f o;
    Vector3f d;
    float tMax = Infinity;
    float time = 0;
    Point3f operator()(float t) const { return o + t * d; }
};

/// Orthonormal frame; ToLocal and FromLocal turn vectors between it and the space of x, y, z.
/// T: float, or several of them side by side.
template <typename T>
struct FrameT {
    Vec3<T> x{T{} + 1, T{}, T{}}, y{T{}, T{} + 1, T{}}, z{T{}, T{}, T{} + 1};

    /// Frame about the unit vector z, x and y anywhere (Duff et al. 2017, "Building an
    /// Orthonormal Basis, Revisited").
    static FrameT FromZ(Vec3<T> z) {
        const T sign = Select(z.z < 0, T(-1), T(1));
        const T a = -1 / (sign + z.z), b = z.x * z.y * a;
        return {
            {1 + sign * Sqr(z.x) * a, sign * b, -sign * z.x}, {b, sign + Sqr(z.y) * a, -z.y}, z};
    }
    /// Frame about the unit vector z with x along the part of `tangent` orthogonal to z; any x
    /// where there is no such part.
    static FrameT FromZTangent(Vec3<T> z, Vec3<T> tangent) {
        const Vec3<T> t = tangent - Dot(tangent, z) * z;
        const T l2 = LengthSquared(t);
        const auto usable = (l2 > 1e-10f * LengthSquared(tangent)) & (l2 < Infinity);
        const Vec3<T> x = t * (1 / Length(t));
        const FrameT along{x, Cross(z, x), z};
        if constexpr (std::is_arithmetic_v<T>) {
            return usable ? along : FromZ(z);
        } else {
            const FrameT any = FromZ(z);
            return {Select(usable, along.x, any.x), Select(usable, along.y, any.y), z};
        }
    }
    Vec3<T> ToLocal(Vec3<T> v) const { return {Dot(v, x), Dot(v, y), Dot(v, z)}; }
    Vec3<T> FromLocal(Vec3<T> v) const { return v.x * x + v.y * y + v.z * z; }
};
using Frame = FrameT<float>;

// Directions in a BxDF's local frame.
inline float CosTheta(Vector3f w) {
    return w.z;
}
inline float AbsCosTheta(Vector3f w) {
    return std::abs(w.z);
}
inline bool SameHemisphere(Vector3f a, Vector3f b) {
    return a.z * b.z > 0;
}

}  // namespace pbrt
