#pragma once

#include "direction.h"

namespace pbrt::feather {

/// An arc of the unit circle, of at most pi, for quadrature without trigonometric functions: the
/// variable x in [-1, 1] is the tangent of half the angle from the arc's middle, scaled.
template <class V>
struct Arc {
    Planar<V> middle;
    V tangent;  ///< of a quarter of the arc's angle, in [0, 1]

    /// From one unit vector counterclockwise to another.
    [[gnu::always_inline]] static Arc Between(const Planar<V> &from, const Planar<V> &to) {
        // from + to is 2 cos(h) middle and the chord, turned back by 90 degrees, 2 sin(h) middle,
        // with h half of the arc's angle: their sum vanishes nowhere in [0, pi/2].
        const Planar<V> sum{from.n + to.n + to.x - from.x, from.x + to.x + from.n - to.n};
        const V scale = 1 / Sqrt(Dot(sum, sum));
        const Planar<V> middle{sum.n * scale, sum.x * scale};
        // Not below 0 where the ends are the same to rounding.
        return {middle, Max(V(0), Cross(middle, to)) / (1 + Dot(middle, to))};
    }

    template <class U>
    struct Node {
        Planar<U> point;
        U rate;  ///< d angle / dx
    };

    template <class U>
    [[gnu::always_inline]] Node<U> At(const U &x) const {
        const U t = tangent * x, scale = 1 / (1 + t * t);
        const U along = (1 - t * t) * scale, across = 2 * t * scale;
        return {{along * middle.n - across * middle.x, along * middle.x + across * middle.n},
                2 * tangent * scale};
    }
};

}  // namespace pbrt::feather
