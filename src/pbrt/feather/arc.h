#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "direction.h"

namespace pbrt::feather {

/// An arc of the unit circle, of at most pi, for quadrature without trigonometric functions: the
/// variable x in [-1, 1] is the tangent of half the angle from the arc's middle, scaled.
template <std::floating_point T>
struct Arc {
    Planar<T> middle;
    T tangent;  ///< of a quarter of the arc's angle, in [0, 1]

    /// From one unit vector counterclockwise to another.
    [[gnu::always_inline]] static Arc Between(Planar<T> from, Planar<T> to) {
        // from + to is 2 cos(h) middle and the chord, turned back by 90 degrees, 2 sin(h) middle,
        // with h half of the arc's angle: their sum vanishes nowhere in [0, pi/2].
        const Planar<T> sum{from.n + to.n + to.x - from.x, from.x + to.x + from.n - to.n};
        const T scale = 1 / std::sqrt(Dot(sum, sum));
        const Planar<T> middle{sum.n * scale, sum.x * scale};
        // Not below 0 where the ends are the same to rounding.
        return {middle, std::max(T(0), Cross(middle, to)) / (1 + Dot(middle, to))};
    }

    template <class V>
    struct Node {
        Planar<V> point;
        V rate;  ///< d angle / dx
    };

    template <class V>
    [[gnu::always_inline]] Node<V> At(const V &x) const {
        const V t = tangent * x, scale = 1 / (1 + t * t);
        const V along = (1 - t * t) * scale, across = 2 * t * scale;
        return {{along * middle.n - across * middle.x, along * middle.x + across * middle.n},
                2 * tangent * scale};
    }
};

}  // namespace pbrt::feather
