#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "bend.h"
#include "direction.h"
#include "quadrature.h"
#include "row.h"

namespace pbrt::feather {

/// Share of light along w, w.z != 0, that passes between the barbules: T(w) of MODEL section 4.3.
///
/// The weight of the segments is uniform in s (see Bend), and Row::Open tells exactly between which
/// s they are open, so Gauss-Legendre sees a smooth function; `Nodes` points on either side of s =
/// 0.
template <int Nodes = 4, std::floating_point T>
T GapFraction(const Row<T> &row, const Bend<T> &bend, Direction<T> w) {
    if (row.Closed()) return 0;
    const Interval<T> range = bend.Weights(w);
    const T rSqr = w.y * w.y + w.z * w.z;
    const Interval<T> open = row.Open(std::abs(w.x), w.x * w.z);
    if (open.lo * open.lo >= rSqr) return 0;
    const T s0 = std::sqrt(std::max(T(0), rSqr - open.hi * open.hi));
    const T s1 = std::sqrt(rSqr - open.lo * open.lo);
    const auto integrate = [&](T lo, T hi) {
        T sum = 0;
        for (int k = 0; k < Nodes; ++k) {
            const T s = (lo + hi) / 2 + (hi - lo) / 2 * kGaussLegendre<T, Nodes>.node[k];
            const T across = std::copysign(std::sqrt(std::max(T(0), rSqr - s * s)), w.z);
            sum += kGaussLegendre<T, Nodes>.weight[k] * row.SeenFrom({across, w.x}).Gap();
        }
        return hi > lo ? sum * (hi - lo) / 2 : T(0);
    };
    const T passed = integrate(std::max(range.lo, s0), std::min(range.hi, s1)) +
                     integrate(std::max(range.lo, -s1), std::min(range.hi, -s0));
    return std::min(T(1), passed / (range.hi - range.lo));
}

}  // namespace pbrt::feather
