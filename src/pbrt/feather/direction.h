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

/// A vector in the plane across a barbule: n along the normal, x across (MODEL section 4.1).
template <std::floating_point T>
struct Planar {
    T n, x;
};

template <std::floating_point T>
[[gnu::always_inline]] constexpr T Dot(Planar<T> a, Planar<T> b) {
    return a.n * b.n + a.x * b.x;
}

/// Positive when b lies counterclockwise of a, from n towards x.
template <std::floating_point T>
[[gnu::always_inline]] constexpr T Cross(Planar<T> a, Planar<T> b) {
    return a.n * b.x - a.x * b.n;
}

}  // namespace pbrt::feather
