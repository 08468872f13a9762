#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>

#include "arc.h"
#include "bend.h"
#include "direction.h"
#include "quadrature.h"
#include "row.h"
#include "thin_film.h"

namespace pbrt::feather {

// The loops below have neither branches nor calls: they become vector code, if everything in them
// is inlined. In a large translation unit compilers stop inlining, so the functions used there
// insist.

/// Nodes of a quadrature over bend angle and cross-section, on [-1, 1]: `Points` for each of
/// `Segments`. Multiples of 4 fill vector registers.
template <std::floating_point T, int Segments, int Points>
struct GridRule {
    std::array<T, Segments> segment, segmentWeight;
    std::array<std::array<T, Points>, Segments> point, weight;
};

/// Gauss by Gauss. `Dealt`: the points are one Gauss rule of Segments * Points, dealt to the
/// segments in turn: as good along the cross-section as that many in every segment, where these
/// differ little.
template <std::floating_point T, int Segments, int Points, bool Dealt>
constexpr GridRule<T, Segments, Points> MakeGridRule() {
    constexpr int kRule = Dealt ? Segments * Points : Points;
    constexpr auto segments = MakeGaussLegendre<T, Segments>();
    constexpr auto points = MakeGaussLegendre<T, kRule>();
    GridRule<T, Segments, Points> rule{segments.node, segments.weight, {}, {}};
    for (int s = 0; s < Segments; ++s)
        for (int k = 0; k < Points; ++k) {
            const int from = Dealt ? k * Segments + s : k;
            rule.point[s][k] = points.node[from];
            rule.weight[s][k] = points.weight[from] * (Dealt ? Segments : 1);
        }
    return rule;
}

template <std::floating_point T, int Segments, int Points, bool Dealt>
inline constexpr auto kGridRule = MakeGridRule<T, Segments, Points, Dealt>();

/// Pairwise, in a fixed order that vector code keeps.
template <std::floating_point T, std::size_t n>
T Sum(const std::array<T, n> &values) {
    if constexpr (n == 1) {
        return values[0];
    } else {
        std::array<T, (n + 1) / 2> half;
        for (std::size_t k = 0; k < n / 2; ++k)
            half[k] = values[k] + values[k + (n + 1) / 2];
        if constexpr (n % 2 == 1) half[n / 2] = values[n / 2];
        return Sum(half);
    }
}

/// Fewer segments than a vector register holds are repeated: scalar code would branch, and be
/// slower.
constexpr int WideEnough(int segments) {
    return segments < 4 ? 4 : segments;
}

/// What wo (first half of each array) and wi see of some segments: their directions in the axes of
/// the ellipse and on the circle, and the first and the last point they see, counterclockwise.
template <std::floating_point T, int Segments>
struct SegmentViews {
    using Both = std::array<T, 2 * Segments>;
    Both axesN, axesX, uN, uX, firstN, firstX, lastN, lastX;

    SegmentViews(const Row<T> &row, Direction<T> wo, Direction<T> wi,
                 const std::array<Segment<T>, Segments> &segments) {
        Both n, x;
        for (int s = 0; s < Segments; ++s) {
            n[s] = segments[s].Across(wo).n;
            n[s + Segments] = segments[s].Across(wi).n;
            x[s] = wo.x;
            x[s + Segments] = wi.x;
        }
        for (int k = 0; k < 2 * Segments; ++k) {
            const Planar<T> axes = row.ToAxes({n[k], x[k]});
            const RowView<T> seen = row.SeenFrom({n[k], x[k]});
            const Planar<T> first = seen.PointAt(seen.lower), last = seen.PointAt(seen.upper);
            axesN[k] = axes.n;
            axesX[k] = axes.x;
            uN[k] = seen.u.n;
            uX[k] = seen.u.x;
            firstN[k] = first.n;
            firstX[k] = first.x;
            lastN[k] = last.n;
            lastX[k] = last.x;
        }
    }
};

/// Whether a comes before b, counterclockwise; both within a right angle of g, or else counted as
/// just there.
template <std::floating_point T>
[[gnu::always_inline]] inline bool Before(Planar<T> g, Planar<T> a, Planar<T> b) {
    constexpr T right = T(1e-6);
    return Cross(g, a) * std::max(Dot(g, b), right) < Cross(g, b) * std::max(Dot(g, a), right);
}

template <std::floating_point T>
[[gnu::always_inline]] inline Planar<T> Choose(bool first, Planar<T> a, Planar<T> b) {
    return {first ? a.n : b.n, first ? a.x : b.x};
}

/// The arc of each segment that both directions see, on the ellipse with axes 1 and `squash`
/// half-way between the circle of e and that of the normals: there fringes and vanishing cosines
/// are spread evenly, and the same error takes half of the points. In units of its height over the
/// chord the arc is chord q (-middle.x, middle.n) + sqrt(1 - (chord q)^2) middle, q in [-1, 1];
/// `share` is `chord`, or 0 if nothing is seen by both.
template <std::floating_point T, int Segments>
struct CommonArcs {
    std::array<T, Segments> middleN, middleX, chord, share;

    CommonArcs(const SegmentViews<T, Segments> &views, T squash) {
        constexpr T opposite = T(1e-3);  // nearly opposite directions share nothing that counts
        for (int s = 0; s < Segments; ++s) {
            const int i = s + Segments;
            // What faces both directions is within a right angle of g; tangents are compared.
            const Planar<T> g{views.uN[s] + views.uN[i], views.uX[s] + views.uX[i]};
            const Planar<T> firstO{views.firstN[s], views.firstX[s]};
            const Planar<T> firstI{views.firstN[i], views.firstX[i]};
            const Planar<T> lastO{views.lastN[s], views.lastX[s]};
            const Planar<T> lastI{views.lastN[i], views.lastX[i]};
            const Planar<T> first = Choose(Before(g, firstO, firstI), firstI, firstO);
            const Planar<T> last = Choose(Before(g, lastI, lastO), lastI, lastO);
            // Not &&, which branches.
            const bool seen = (int(Before(g, first, last)) & int(Dot(g, g) > 2 * opposite)) != 0;
            const Planar<T> from{first.n, squash * first.x}, to{last.n, squash * last.x};
            // At least 0.4 but for a direction along the barbule, whose points are at 0.
            const T fromLength = std::sqrt(std::max(Dot(from, from), T(0.1)));
            const T toLength = std::sqrt(std::max(Dot(to, to), T(0.1)));
            // As in Arc::Between, of the unit vectors times both lengths.
            const Planar<T> a{from.n * toLength, from.x * toLength};
            const Planar<T> b{to.n * fromLength, to.x * fromLength};
            const Planar<T> sum{a.n + b.n + b.x - a.x, a.x + b.x + a.n - b.n};
            const T scale = 1 / std::sqrt(std::max(Dot(sum, sum), std::numeric_limits<T>::min()));
            middleN[s] = sum.n * scale;
            middleX[s] = sum.x * scale;
            chord[s] = Cross(sum, to) * scale / toLength;
            share[s] = seen ? chord[s] : T(0);
        }
    }
};

/// The nodes of a rule: squared cosines to both directions, and weights with all else that the film
/// does not change.
template <std::floating_point T, int Segments, int Points>
struct PigmentNodes {
    static constexpr int kWide = WideEnough(Segments);
    std::array<T, Segments * Points> cosSqrO, cosSqrI, weight;

    PigmentNodes(const SegmentViews<T, kWide> &views, const CommonArcs<T, kWide> &arcs, T b,
                 T squash, const GridRule<T, Segments, Points> &rule,
                 const std::array<T, Segments> &segmentWeight) {
        const T unsquash = 1 / squash;
        for (int s = 0; s < Segments; ++s)
            for (int k = 0; k < Points; ++k) {
                const int at = s * Points + k, i = s + kWide;
                const T q = arcs.chord[s] * rule.point[s][k], along = std::sqrt(1 - q * q);
                const T n = along * arcs.middleN[s] - q * arcs.middleX[s];
                const T x = (along * arcs.middleX[s] + q * arcs.middleN[s]) * unsquash;
                // Squared lengths of the point and of its normal; cosines times the latter's root.
                const T length = n * n + x * x, normal = n * n + b * b * x * x;
                const T o = std::max(T(0), views.axesN[s] * n + views.axesX[s] * b * x);
                const T c = std::max(T(0), views.axesN[i] * n + views.axesX[i] * b * x);
                cosSqrO[at] = o * o / normal;
                cosSqrI[at] = c * c / normal;
                weight[at] = segmentWeight[s] * arcs.share[s] * rule.weight[s][k] * o * c /
                             (along * length * std::sqrt(length * normal));
            }
    }
};

/// The integral of TRT (see PigmentIntegral) by a rule known at compile time.
template <int Segments, int Points, std::floating_point T, std::size_t N>
std::array<T, N> PigmentByRule(const Row<T> &row, const Bend<T> &bend,
                               const std::array<Film<T>, N> &films, Direction<T> wo,
                               Direction<T> wi, const GridRule<T, Segments, Points> &rule) {
    const std::optional<Arc<T>> seen = bend.SeenByBoth(wo, wi);
    if (!seen) return {};
    constexpr int kWide = WideEnough(Segments);
    std::array<Segment<T>, kWide> segments;
    std::array<T, Segments> segmentWeight;
    for (int k = 0; k < kWide; ++k) {
        const int s = k % Segments;
        const auto [a, rate] = seen->At(rule.segment[s]);
        segments[k] = {a.x, a.n};
        segmentWeight[s] = rate * rule.segmentWeight[s];
    }
    const T squash = std::clamp(std::sqrt(row.Aspect()), T(0.4), T(2.5));
    const SegmentViews<T, kWide> views(row, wo, wi, segments);
    const CommonArcs<T, kWide> arcs(views, squash);
    if (Sum(arcs.share) == 0) return {};
    const PigmentNodes<T, Segments, Points> nodes(views, arcs, row.Aspect(), squash, rule,
                                                  segmentWeight);

    const T scale = 1 / (2 * row.Spacing() * bend.SinOpening() * squash);
    std::array<T, N> integral;
    for (std::size_t i = 0; i < N; ++i) {
        std::array<T, Segments * Points> part;
        for (int k = 0; k < Segments * Points; ++k)
            part[k] = nodes.weight[k] * films[i].ThroughTwice(nodes.cosSqrO[k], nodes.cosSqrI[k]);
        integral[i] = Sum(part) * scale;
    }
    return integral;
}

/// A quadrature for Barbule: always the same rule.
template <int Segments, int Points, bool Dealt>
struct FixedRule {
    template <std::floating_point T, std::size_t N>
    static std::array<T, N> Integrate(const Row<T> &row, const Bend<T> &bend,
                                      const std::array<Film<T>, N> &films, Direction<T> wo,
                                      Direction<T> wi) {
        return PigmentByRule(row, bend, films, wo, wi, kGridRule<T, Segments, Points, Dealt>);
    }
};

/// The quadrature that renders: more segments where the arc is bent or seen along its slope, so
/// that they differ more; more points where a thick film has more fringes. Error rms relative to
/// the mean, of light (f |cos cos|): 0.07 % at the defaults, below 0.2 % for shapes of the paper,
/// 0.35 % for d = 2 um, 1.2 % for 5 um; of f, with its weight on grazing pairs, 0.2 %. MODEL's 8 x
/// 2 nodes in e and a: 0.37 and 1.9 % at the defaults, 1.4 % for 2 um.
struct AdaptiveRule {
    template <std::floating_point T, std::size_t N>
    static std::array<T, N> Integrate(const Row<T> &row, const Bend<T> &bend,
                                      const std::array<Film<T>, N> &films, Direction<T> wo,
                                      Direction<T> wi) {
        T fringes = 0;
        for (const Film<T> &film : films)
            fringes = std::max(fringes, film.fringes);
        const int segments = Segments(bend, fringes, wo, wi);
        return fringes > 4 ? WithPoints<16>(segments, row, bend, films, wo, wi)
                           : WithPoints<8>(segments, row, bend, films, wo, wi);
    }

  private:
    template <std::floating_point T>
    static int Segments(const Bend<T> &bend, T fringes, Direction<T> wo, Direction<T> wi) {
        // By how much |w.z_a| changes along the arc, relative to its middle, is above `change`.
        const auto slanted = [&](T change) {
            return std::abs(wo.y) * bend.SinOpening() > change * std::abs(wo.z) ||
                   std::abs(wi.y) * bend.SinOpening() > change * std::abs(wi.z);
        };
        const bool alike = bend.Opening() * std::max(T(1), fringes / T(2.5)) <= T(0.2);
        if (alike && !slanted(T(0.3))) return 2;
        return bend.Opening() > T(0.7) || slanted(T(0.6)) ? 8 : 4;
    }

    template <int Points, std::floating_point T, std::size_t N>
    static std::array<T, N> WithPoints(int segments, const Row<T> &row, const Bend<T> &bend,
                                       const std::array<Film<T>, N> &films, Direction<T> wo,
                                       Direction<T> wi) {
        switch (segments) {
            case 2:
                return FixedRule<2, Points, true>::Integrate(row, bend, films, wo, wi);
            case 4:
                return FixedRule<4, Points, false>::Integrate(row, bend, films, wo, wi);
            default:
                return FixedRule<8, Points, false>::Integrate(row, bend, films, wo, wi);
        }
    }
};

}  // namespace pbrt::feather
