#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "../simd/math.h"
#include "../simd/permute.h"
#include "arc.h"
#include "bend.h"
#include "direction.h"
#include "fields.h"
#include "pigment_nodes.h"
#include "pigment_rule.h"
#include "quadrature.h"
#include "row.h"
#include "thin_film.h"

namespace pbrt::feather {

/// The integral of TRT of sixteen pairs of directions (see PigmentIntegral), by the rules of
/// RuleChoice.
///
/// First two segments of every pair, a pair a lane. What pairs with more segments have left is
/// gathered, a segment a lane; where that fills few lanes, teams of two or four divide a segment's
/// points. kRough: some films are.
template <std::floating_point T, std::size_t N, bool kRough>
class PigmentX16 {
  public:
    using V = SimdX16<T>;

    /// All must outlive this.
    PigmentX16(const Row<V> &row, const Bend<V> &bend, const std::array<Film<V>, N> &films,
               const Direction<V> &wo, const Direction<V> &wi)
        : row(row), bend(bend), films(films), choice(row, bend, films, wo, wi) {
        const auto [shared, any] = bend.SeenByBoth(wo, wi);
        pairs = {wo, wi, shared};
        seen = any;
    }

    /// Lanes that are `off` give 0.
    void Integrate(const MaskFor<V> &off, std::array<V, N> *integral) {
        const auto on = seen & !off;
        sums.fill(V(0));
        AddAll<4>(on & (choice.points == 4));
        AddAll<8>(on & (choice.points == 8));
        AddAll<16>(on & (choice.points == 16));
        const V scale = 1 / (4 * row.Spacing() * bend.SinOpening() * row.Squash());
        for (std::size_t i = 0; i < N; ++i)
            (*integral)[i] = Select(on, sums[i] * scale, V(0));
    }

  private:
    using Numbers = std::array<T, kPacketSize>;

    struct Pairs {
        Direction<V> wo, wi;
        Arc<V> arc;  ///< the bend angles that both see
        auto Fields() { return FieldsOf(*this); }
        auto Fields() const { return FieldsOf(*this); }

      private:
        template <class Self>
        static auto FieldsOf(Self &p) {
            return std::tie(p.wo.x, p.wo.y, p.wo.z, p.wi.x, p.wi.y, p.wi.z, p.arc.middle.n,
                            p.arc.middle.x, p.arc.tangent);
        }
    };

    /// Nodes and weights in the bend, by some number.
    struct Table {
        Numbers node{}, weight{};
        V NodeAt(const IntX16 &index) const { return Permute(V::Load(node.data()), index); }
        V WeightAt(const IntX16 &index) const { return Permute(V::Load(weight.data()), index); }
    };
    template <int n>
    static constexpr void Copy(int segment, Table *to, int place) {
        to->node[place] = kGaussLegendre<T, n>.node[segment];
        to->weight[place] = kGaussLegendre<T, n>.weight[segment];
    }
    /// The first and the second of n segments, by n.
    static constexpr std::array<Table, 2> kFirst = [] {
        std::array<Table, 2> tables;
        for (int k = 0; k < 2; ++k) {
            Copy<2>(k, &tables[k], 2);
            Copy<3>(k, &tables[k], 3);
            Copy<4>(k, &tables[k], 4);
            Copy<6>(k, &tables[k], 6);
            Copy<8>(k, &tables[k], 8);
        }
        return tables;
    }();
    /// One table holds the segments from the third on of all rules, one rule after another, so that
    /// sixteen segments of different rules are looked up at once. By the number n of a rule's
    /// segments: the place of its third one. A rule has n - 2 such segments: 1, 2, 4 and 6.
    static constexpr std::array<int, 9> kThirdOf = {-1, -1, -1, 0, 1, -1, 3, -1, 7};
    /// A place behind them all: its weight is 0.
    static constexpr int kNone = kPacketSize - 1;
    static_assert(kThirdOf[8] + 6 <= kNone);
    static constexpr Table kRest = [] {
        Table table;
        Copy<3>(2, &table, kThirdOf[3]);
        for (int k = 0; k < 2; ++k)
            Copy<4>(2 + k, &table, kThirdOf[4] + k);
        for (int k = 0; k < 4; ++k)
            Copy<6>(2 + k, &table, kThirdOf[6] + k);
        for (int k = 0; k < 6; ++k)
            Copy<8>(2 + k, &table, kThirdOf[8] + k);
        return table;
    }();

    /// The points of a segment on which kTeam lanes in a row work, each on every kTeam-th: node j
    /// of lane l.
    template <int Points, int kTeam>
    struct TeamPoints {
        std::array<Numbers, Points / kTeam> node, weight;
    };
    template <int Points, int kTeam>
    static constexpr TeamPoints<Points, kTeam> MakeTeamPoints() {
        TeamPoints<Points, kTeam> points{};
        for (int j = 0; j < Points / kTeam; ++j)
            for (int l = 0; l < kPacketSize; ++l) {
                points.node[j][l] = kGaussLegendre<T, Points>.node[j * kTeam + l % kTeam];
                points.weight[j][l] = kGaussLegendre<T, Points>.weight[j * kTeam + l % kTeam];
            }
        return points;
    }
    template <int Points, int kTeam>
    static constexpr auto kTeamPoints = MakeTeamPoints<Points, kTeam>();

    template <int Points>
    void AddAll(const MaskFor<V> &on) {
        const uint32_t lanes = BitsOf(on);
        if (lanes == 0) return;
        AddFirst<Points, 0>(on);
        AddFirst<Points, 1>(on);
        const uint32_t more = lanes & BitsOf(choice.segments > 2);
        if (more != 0) AddRest<Points>(more);
    }

    /// Segment k = 0, 1 of each pair.
    template <int Points, int k>
    void AddFirst(const MaskFor<V> &on) {
        const auto two = choice.segments == 2;
        const auto pointAt = [&](int j) __attribute__((always_inline)) {
            const RulePoint<T> interleaved = kInterleaved<Points>[k][j],
                               own = PointOf<T, 1, Points, false>(0, j);
            return std::pair{Select(two, V(interleaved.node), V(own.node)),
                             Select(two, V(interleaved.weight), V(own.weight))};
        };
        const IntX16 index = Convert<int32_t>(choice.segments);
        std::array<V, N> more;
        Segment<Points>(
            row, pairs, [&](std::size_t i) -> auto & { return TwiceOf<kRough>(films[i]); },
            kFirst[k].NodeAt(index), kFirst[k].WeightAt(index), pointAt, &more);
        for (std::size_t i = 0; i < N; ++i)
            sums[i] = Select(on, sums[i] + more[i], sums[i]);
    }
    template <int Points>
    static constexpr auto kInterleaved = [] {
        std::array<std::array<RulePoint<T>, Points>, 2> points{};
        for (int k = 0; k < 2; ++k)
            for (int j = 0; j < Points; ++j)
                points[k][j] = PointOf<T, 2, Points, true>(k, j);
        return points;
    }();

    /// Adds the remaining segments of the given lanes' pairs, sixteen at a time.
    template <int Points>
    void AddRest(uint32_t lanes) {
        T segments[kPacketSize];
        choice.segments.Store(segments);
        int32_t pair[7 * kPacketSize], segment[7 * kPacketSize];
        int count = 0;
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes), n = int(segments[lane]);
            for (int k = 0; k < n - 2; ++k, ++count)
                pair[count] = lane, segment[count] = kThirdOf[n] + k;
        }
        std::fill_n(pair + count, kPacketSize, 0);
        std::fill_n(segment + count, kPacketSize, kNone);
        for (int from = 0; from < count; from += kPacketSize) {
            const int left = count - from;
            if (left <= 4)
                AddGathered<Points, 4>(pair + from, segment + from, left);
            else if (left <= 8)
                AddGathered<Points, 2>(pair + from, segment + from, left);
            else
                AddGathered<Points, 1>(pair + from, segment + from, std::min(left, kPacketSize));
        }
    }

    /// `count` segments, each by a team of kTeam lanes, which divide its points among them.
    template <int Points, int kTeam>
    [[gnu::noinline]] void AddGathered(const int32_t *pair, const int32_t *segment, int count) {
        const IntX16 pairOf = Repeat<kTeam>(pair), segmentOf = Repeat<kTeam>(segment);
        Row<V> rowThere;
        Pairs there;
        std::array<std::remove_cvref_t<decltype(TwiceOf<kRough>(films[0]))>, N> filmsThere;
        PermuteFields(rowThere.Fields(), row.Fields(), pairOf);
        PermuteFields(there.Fields(), std::as_const(pairs).Fields(), pairOf);
        for (std::size_t i = 0; i < N; ++i)
            PermuteFields(filmsThere[i].Fields(), TwiceOf<kRough>(films[i]).Fields(), pairOf);
        constexpr auto &points = kTeamPoints<Points, kTeam>;
        std::array<V, N> more;
        Segment<Points / kTeam>(
            rowThere, there, [&](std::size_t i) -> auto & { return filmsThere[i]; },
            kRest.NodeAt(segmentOf), kRest.WeightAt(segmentOf),
            [&](int j) __attribute__((always_inline)) {
                return std::pair{V::Load(points.node[j].data()), V::Load(points.weight[j].data())};
            },
            &more);
        for (std::size_t i = 0; i < N; ++i) {
            if constexpr (kTeam > 1)
                more[i] = more[i] + Permute(more[i], [](int k) { return k ^ 1; });
            if constexpr (kTeam > 2)
                more[i] = more[i] + Permute(more[i], [](int k) { return k ^ 2; });
            for (int k = 0; k < count; ++k)
                sums[i].Set(pair[k], sums[i][pair[k]] + more[i][k * kTeam]);
        }
    }

    /// Contribution of one segment, at `node` of the bend and with that weight, to each wavelength;
    /// anything where the weight is 0. pointAt(j) gives node and weight of point j < Points.
    template <int Points, class FilmAt, class PointAt>
    [[gnu::always_inline]] static void Segment(const Row<V> &row, const Pairs &p,
                                               const FilmAt &film, const V &node, const V &weight,
                                               const PointAt &pointAt, std::array<V, N> *sum) {
        const auto bent = p.arc.At(node);
        const auto across = [&](const Direction<V> &w) {
            return Planar<V>{w.y * bent.point.x + w.z * bent.point.n, w.x};
        };
        const SegmentViews<V> o(row, across(p.wo)), i(row, across(p.wi));
        const CommonArcs<V> arcs = SeenByBoth(o, i, row.Squash());
        const PigmentNodes<V> nodes(arcs.middle, arcs.chord, arcs.chord * (bent.rate * weight),
                                    o.axes, i.axes, row.Aspect(), row.Squash());
        sum->fill(V(0));
        for (int j = 0; j < Points; ++j) {
            const auto [point, pointWeight] = pointAt(j);
            const auto at = nodes.At(point, pointWeight);
            [&]<std::size_t... k>(std::index_sequence<k...>) {
                (((*sum)[k] = (*sum)[k] + film(k).Weighted(at.weight, at.cosSqrO, at.cosSqrI)),
                 ...);
            }
            (std::make_index_sequence<N>());
        }
    }

    const Row<V> &row;
    const Bend<V> &bend;
    const std::array<Film<V>, N> &films;
    RuleChoice<V> choice;
    Pairs pairs;
    MaskFor<V> seen;
    std::array<V, N> sums;
};

}  // namespace pbrt::feather
