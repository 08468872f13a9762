#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <utility>

#include "../simd/permute.h"
#include "arc.h"
#include "bend.h"
#include "direction.h"
#include "pigment_nodes.h"
#include "pigment_rule.h"
#include "pigment_x16.h"
#include "quadrature.h"
#include "row.h"
#include "thin_film.h"

namespace pbrt::feather {

/// Number of a rule's segments found at once: with both directions at most eight floats.
constexpr int SegmentsAtOnce(int segments) {
    return segments <= 2 ? 2 : 4;
}

/// Nodes of a quadrature over bend angle and cross-section, on [-1, 1]: `Points`, a power of two,
/// for each of `Segments`, 2 or more. In a group come all segments' first points, all second ones
/// and so on; the last group is filled up with segments of no weight.
template <std::floating_point T, int Segments, int Points>
struct GridRule {
    static constexpr int kAtOnce = SegmentsAtOnce(Segments),
                         kGroups = (Segments + kAtOnce - 1) / kAtOnce;
    struct Group {
        std::array<T, 2 * kAtOnce> segment, segmentWeight;  ///< twice, see SegmentViews
        std::array<T, kAtOnce * Points> point, weight;
    };
    std::array<Group, kGroups> groups;
};

/// Gauss by Gauss. `Interleaved`: the points are one Gauss rule of Segments * Points, interleaved
/// to the segments in turn: as good along the cross-section as that many in every segment, where
/// these differ little.
template <std::floating_point T, int Segments, int Points, bool Interleaved>
constexpr GridRule<T, Segments, Points> MakeGridRule() {
    constexpr auto segments = MakeGaussLegendre<T, Segments>();
    GridRule<T, Segments, Points> rule{};
    constexpr int n = rule.kAtOnce;
    static_assert(!Interleaved || Segments % n == 0);
    for (int g = 0; g < rule.kGroups; ++g) {
        auto &group = rule.groups[g];
        for (int k = 0; k < 2 * n; ++k) {
            const int from = g * n + k % n;
            if (from >= Segments) continue;
            group.segment[k] = segments.node[from];
            group.segmentWeight[k] = segments.weight[from];
        }
        for (int k = 0; k < n * Points; ++k) {
            const auto point = PointOf<T, Segments, Points, Interleaved>(g * n + k % n, k / n);
            group.point[k] = point.node;
            group.weight[k] = point.weight;
        }
    }
    return rule;
}

template <std::floating_point T, int Segments, int Points, bool Interleaved>
inline constexpr auto kGridRule = MakeGridRule<T, Segments, Points, Interleaved>();

/// The integral of TRT (see PigmentIntegral) by a rule known at compile time. kRough: of films
/// whose thickness varies.
///
/// One pair of directions has a text of its own beside PigmentX16's: here a segment's views from wo
/// and from wi fill the halves of one vector. PigmentX16::Segment with a point of the one pair in
/// each of eight lanes takes longer: with AVX-512 0 % for 4 x 2 points, 6 % for 8 x 2 and 4 x 4, 3
/// % for 8 x 4; with AVX2 9, 10, 6 and 2 %.
template <bool kRough, int Segments, int Points, std::floating_point T, std::size_t N>
void PigmentByRule(const Row<T> &row, const Bend<T> &bend, const std::array<Film<T>, N> &films,
                   const Direction<T> &wo, const Direction<T> &wi,
                   const GridRule<T, Segments, Points> &rule, std::array<T, N> *integral) {
    constexpr int kSegments = GridRule<T, Segments, Points>::kAtOnce, kNodes = kSegments * Points;
    constexpr int kAtOnce = std::min(kNodes, 8);
    using Sides = Simd<T, 2 * kSegments>;
    using Nodes = Simd<T, kAtOnce>;
    const auto [arc, any] = bend.SeenByBoth(wo, wi);
    if (!any) {
        *integral = {};
        return;
    }
    const T squash = row.Squash(), scale = 1 / (4 * row.Spacing() * bend.SinOpening() * squash);
    const Sides wx = JoinHalves<Sides>(wo.x, wi.x), wy = JoinHalves<Sides>(wo.y, wi.y),
                wz = JoinHalves<Sides>(wo.z, wi.z);
    const auto repeat = [](const Sides &sides) __attribute__((always_inline)) {
        return Repeated<kAtOnce>(sides);
    };
    Nodes sum[N];
    std::fill_n(sum, N, Nodes(0));
    for (const auto &group : rule.groups) {
        const auto [a, rate] = arc.At(Sides::Load(group.segment.data()));
        const SegmentViews<Sides> views(row, {wy * a.x + wz * a.n, wx});
        const CommonArcs<Sides> arcs = SeenByBoth(views, squash);
        const PigmentNodes<Nodes> nodes(
            {repeat(arcs.middle.n), repeat(arcs.middle.x)}, repeat(arcs.chord),
            repeat(arcs.chord * (rate * Sides::Load(group.segmentWeight.data()))),
            {repeat(DuplicateLow(views.axes.n)), repeat(DuplicateLow(views.axes.x))},
            {repeat(DuplicateHigh(views.axes.n)), repeat(DuplicateHigh(views.axes.x))},
            row.Aspect(), squash);
        for (int from = 0; from < kNodes; from += kAtOnce) {
            const auto at =
                nodes.At(Nodes::Load(&group.point[from]), Nodes::Load(&group.weight[from]));
            // Not a loop, see simd/registers.h.
            [&]<std::size_t... i>(std::index_sequence<i...>) {
                ((sum[i] = sum[i] +
                           TwiceOf<kRough>(films[i]).Weighted(at.weight, at.cosSqrO, at.cosSqrI)),
                 ...);
            }
            (std::make_index_sequence<N>());
        }
    }
    for (std::size_t i = 0; i < N; ++i)
        (*integral)[i] = Sum(sum[i]) * scale;
}

/// A quadrature for Barbule: always the same rule.
template <int Segments, int Points, bool Interleaved>
struct FixedRule {
    template <std::floating_point T, std::size_t N>
    static void Integrate(const Row<T> &row, const Bend<T> &bend,
                          const std::array<Film<T>, N> &films, const Direction<T> &wo,
                          const Direction<T> &wi, std::array<T, N> *integral) {
        constexpr auto &rule = kGridRule<T, Segments, Points, Interleaved>;
        if (AnyRough(films))
            PigmentByRule<true>(row, bend, films, wo, wi, rule, integral);
        else
            PigmentByRule<false>(row, bend, films, wo, wi, rule, integral);
    }
};

/// The quadrature that renders: for each pair of directions the rule that RuleChoice finds. Error
/// rms relative to the mean, of light (f |cos cos|): 0.14 % at the defaults, below 0.4 % for shapes
/// of the paper, 0.35 % for d = 2 um, 1.2 % for 5 um; of f, with its weight on grazing pairs, 0.5
/// %, and below 0.8 %. MODEL's 8 x 2 nodes in e and a: 0.37 and 1.9 % at the defaults, 1.4 % for 2
/// um.
struct AdaptiveRule {
    template <std::floating_point T, std::size_t N>
    static void Integrate(const Row<T> &row, const Bend<T> &bend,
                          const std::array<Film<T>, N> &films, const Direction<T> &wo,
                          const Direction<T> &wi, std::array<T, N> *integral) {
        const RuleChoice<T> choice(row, bend, films, wo, wi);
        const int segments = int(choice.segments);
        if (choice.points == 4)
            WithPoints<4>(segments, row, bend, films, wo, wi, integral);
        else if (choice.points == 8)
            WithPoints<8>(segments, row, bend, films, wo, wi, integral);
        else
            WithPoints<16>(segments, row, bend, films, wo, wi, integral);
    }

    /// Sixteen pairs side by side, each by its own rule. Lanes that are `off` give 0.
    template <std::floating_point T, std::size_t N>
    static void Integrate(const Row<SimdX16<T>> &row, const Bend<SimdX16<T>> &bend,
                          const std::array<Film<SimdX16<T>>, N> &films,
                          const Direction<SimdX16<T>> &wo, const Direction<SimdX16<T>> &wi,
                          const MaskFor<SimdX16<T>> &off, std::array<SimdX16<T>, N> *integral) {
        if (AnyRough(films))
            PigmentX16<T, N, true>(row, bend, films, wo, wi).Integrate(off, integral);
        else
            PigmentX16<T, N, false>(row, bend, films, wo, wi).Integrate(off, integral);
    }

  private:
    template <int Points, std::floating_point T, std::size_t N>
    static void WithPoints(int segments, const Row<T> &row, const Bend<T> &bend,
                           const std::array<Film<T>, N> &films, const Direction<T> &wo,
                           const Direction<T> &wi, std::array<T, N> *integral) {
        switch (segments) {
            case 2:
                return FixedRule<2, Points, true>::Integrate(row, bend, films, wo, wi, integral);
            case 3:
                return FixedRule<3, Points, false>::Integrate(row, bend, films, wo, wi, integral);
            case 4:
                return FixedRule<4, Points, false>::Integrate(row, bend, films, wo, wi, integral);
            case 6:
                return FixedRule<6, Points, false>::Integrate(row, bend, films, wo, wi, integral);
            default:
                return FixedRule<8, Points, false>::Integrate(row, bend, films, wo, wi, integral);
        }
    }
};

}  // namespace pbrt::feather
