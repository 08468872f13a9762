#pragma once

#include "../simd/math.h"

namespace pbrt::feather {

using pbrt::Select;  // of scalars, beside those of directions

/// A unit vector that points away from the surface, in the local frame of the vane:
/// z the surface normal, y along the barbules, x across them.
template <class V>
struct Direction {
    V x, y, z;
    friend constexpr Direction operator-(const Direction &w) { return {-w.x, -w.y, -w.z}; }
};

template <class V>
[[gnu::always_inline]] constexpr V Dot(const Direction<V> &a, const Direction<V> &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// True where w counts as in the plane of the vane, from where nothing is seen.
template <class V>
[[gnu::always_inline]] constexpr MaskFor<V> Grazing(const Direction<V> &w) {
    using T = ScalarOf<V>;
    return (V(-T(1e-12)) < w.z) & (w.z < V(T(1e-12)));
}

template <class V>
[[gnu::always_inline]] inline Direction<V> Select(const MaskFor<V> &mask, const Direction<V> &a,
                                                  const Direction<V> &b) {
    return {Select(mask, a.x, b.x), Select(mask, a.y, b.y), Select(mask, a.z, b.z)};
}

/// A vector in the plane across a barbule: n along the normal, x across (MODEL section 4.1). V is a
/// scalar or several: so many vectors.
template <class V>
struct Planar {
    V n, x;
};

template <class V>
[[gnu::always_inline]] inline Planar<V> Select(const MaskFor<V> &mask, const Planar<V> &a,
                                               const Planar<V> &b) {
    return {Select(mask, a.n, b.n), Select(mask, a.x, b.x)};
}

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
