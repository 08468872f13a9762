#pragma once

#include <concepts>

namespace pbrt::feather {

/// A unit vector that points away from the surface, in the local frame of the vane:
/// z the surface normal, y along the barbules, x across them.
template <std::floating_point T>
struct Direction {
    T x, y, z;
    friend constexpr Direction operator-(Direction w) { return {-w.x, -w.y, -w.z}; }
};

template <std::floating_point T>
constexpr T Dot(Direction<T> a, Direction<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Whether w counts as in the plane of the vane, from where nothing is seen.
template <std::floating_point T>
constexpr bool Grazing(const Direction<T> &w) {
    return -T(1e-12) < w.z && w.z < T(1e-12);
}

/// A vector in the plane across a barbule: n along the normal, x across (MODEL section 4.1). V is a
/// scalar or a Pack: so many vectors.
template <class V>
struct Planar {
    V n, x;
};

template <class V>
[[gnu::always_inline]] constexpr V Dot(const Planar<V> &a, const Planar<V> &b) {
    return a.n * b.n + a.x * b.x;
}

/// Positive when b lies counterclockwise of a, from n towards x.
template <class V>
[[gnu::always_inline]] constexpr V Cross(const Planar<V> &a, const Planar<V> &b) {
    return a.n * b.x - a.x * b.n;
}

}  // namespace pbrt::feather
