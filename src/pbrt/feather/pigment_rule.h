#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "../simd/math.h"
#include "bend.h"
#include "direction.h"
#include "quadrature.h"
#include "row.h"
#include "thin_film.h"

namespace pbrt::feather {

/// A node of a rule over the cross-section, on [-1, 1].
template <std::floating_point T>
struct RulePoint {
    T node, weight;
};

/// Four points for the first of two segments; the second has their mirror images. Nodes and weights
/// are a least-squares fit, half to light and half to f, over sixteen shapes (thickness 200 to 650,
/// spacing 0.8 to 1.5, tilt -0.8 to 0.3, aspect 0.15 to 1, opening 0.03 to 0.15) and 800 pairs of
/// directions each: 0.12 % of light for 0.19 % with the eight points of Gauss, 0.27 % of f for
/// 0.35.
inline constexpr std::array<RulePoint<double>, 4> kFittedPoints{{{-0.96832343, 0.16157837},
                                                                 {-0.57207730, 0.61620130},
                                                                 {0.21012308, 0.81861817},
                                                                 {0.82849701, 0.40368949}}};

/// A point of `Points` in each of `Segments`. Interleaved: they are one rule of Segments * Points,
/// interleaved to the segments in turn: kFittedPoints where these are as many, else Gauss.
template <std::floating_point T, int Segments, int Points, bool Interleaved>
constexpr RulePoint<T> PointOf(int segment, int point) {
    if constexpr (Interleaved && Segments == 2 && Points == int(kFittedPoints.size())) {
        const auto [node, weight] = kFittedPoints[segment == 0 ? point : Points - 1 - point];
        return {T(segment == 0 ? node : -node), T(weight)};
    } else {
        constexpr int kAll = Interleaved ? Segments * Points : Points;
        constexpr auto &rule = kGaussLegendre<T, kAll>;
        const int k = Interleaved ? point * Segments + segment : point;
        return {rule.node[k], rule.weight[k] * (Interleaved ? Segments : 1)};
    }
}

/// Rule that integrates TRT of a pair of directions (or each of sixteen): 2 segments with
/// interleaved points, or 3, 4, 6 or 8 segments; 4, 8 or 16 points in each.
///
/// More segments where the arc is bent or seen along its slope, so that they differ more; most
/// where one end is seen nearly edge-on, for what is seen there goes like a root. More points where
/// a thick film has more fringes, or wide gaps show long arcs.
template <class V>
struct RuleChoice {
    V segments, points;

    template <std::size_t N>
    [[gnu::always_inline]] RuleChoice(const Row<V> &row, const Bend<V> &bend,
                                      const std::array<Film<V>, N> &films, const Direction<V> &wo,
                                      const Direction<V> &wi) {
        using T = ScalarOf<V>;
        V fringes(0);
        for (const Film<V> &film : films)
            fringes = Max(fringes, film.fringes);
        // By how much |w.z_a| changes along the arc, relative to its middle, is above `change`.
        const V slopeO = Abs(wo.y) * bend.SinOpening(), slopeI = Abs(wi.y) * bend.SinOpening(),
                heightO = Abs(wo.z), heightI = Abs(wi.z);
        const auto slanted = [&](T change) -> MaskFor<V> {
            return (slopeO > change * heightO) | (slopeI > change * heightI);
        };
        const MaskFor<V> alike = bend.Opening() * Max(V(1), fringes * T(0.4)) <= T(0.2);
        const MaskFor<V> edgeOn = slanted(T(0.9)) & !slanted(T(1.6));
        // Of an arc whose segments are alike: between slopes, and beyond, 3.
        const V ofAlike = Select(slanted(T(0.6)) & !slanted(T(0.9)), V(4), V(3));
        segments = Select(alike, Select(slanted(T(0.3)), ofAlike, V(2)), V(4));
        segments = Select(bend.Opening() > T(0.7), V(8), Select(edgeOn, V(6), segments));
        points = Select(alike & (fringes < T(1.4)) & (row.Spacing() < T(1.6)), V(4),
                        Select(fringes < T(4), V(8), V(16)));
    }
};

}  // namespace pbrt::feather
