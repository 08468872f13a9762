#pragma once

#include <concepts>
#include <limits>

#include "../simd/math.h"
#include "../simd/permute.h"
#include "direction.h"
#include "row.h"

namespace pbrt::feather {

// Structs of several vectors are made in place and never copied, see simd/registers.h.

/// Visible parts of some segments: the direction in the axes of the ellipse, and the first and the
/// last point that it sees, counterclockwise. `Sides` are sixteen numbers, a segment each, or a
/// vector with the segments as wo sees them in one half and as wi does in the other.
template <class Sides>
struct SegmentViews {
    Planar<Sides> axes;
    RowView<Sides> seen;
    Planar<Sides> first, last;  ///< times reach^2

    template <class V>
    [[gnu::always_inline]] SegmentViews(const Row<V> &row, const Planar<Sides> &across)
        : axes(row.ToAxes(across)),
          seen(row.SeenFrom(across)),
          first(seen.ScaledPointAt(seen.lower)),
          last(seen.ScaledPointAt(seen.upper)) {}
};

/// A point, of any length, as seen along g: of two within a right angle of g the one with the
/// smaller across / along comes first, counterclockwise. Others count as just there.
template <class Sides>
struct Bearing {
    Planar<Sides> point;
    Sides across, along;

    [[gnu::always_inline]] static Bearing Of(const Planar<Sides> &g, const Planar<Sides> &point,
                                             const Sides &least) {
        return {{point.n, point.x}, Cross(g, point), Max(Dot(g, point), least)};
    }
    /// The same point's of the other direction, along the same g.
    [[gnu::always_inline]] Bearing OtherSide() const {
        return {{SwapHalves(point.n), SwapHalves(point.x)}, SwapHalves(across), SwapHalves(along)};
    }
    [[gnu::always_inline]] friend auto Before(const Bearing &a, const Bearing &b) {
        return a.across * b.along < b.across * a.along;
    }
    template <class Mask>
    [[gnu::always_inline]] friend Bearing Choose(const Mask &first, const Bearing &a,
                                                 const Bearing &b) {
        return {{Select(first, a.point.n, b.point.n), Select(first, a.point.x, b.point.x)},
                Select(first, a.across, b.across),
                Select(first, a.along, b.along)};
    }
};

/// An arc of each segment on the unit circle. In units of its height over the chord it is
/// chord q (-middle.x, middle.n) + sqrt(1 - (chord q)^2) middle, q in [-1, 1]. `chord` is 0 where
/// there is none.
template <class Sides>
struct CommonArcs {
    Planar<Sides> middle;
    Sides chord;

    /// The arcs between two vectors of any length, counterclockwise and of at most pi, if `seen`.
    ///
    /// Of their unit vectors a and b and the angle w between them, a + b and the chord, turned back
    /// by 90 degrees, sum to 2 sqrt(1 + sin w) middle, which vanishes nowhere, and
    /// chord = (1 + sin w - cos w) / (2 sqrt(1 + sin w)).
    template <class Mask>
    [[gnu::always_inline]] static CommonArcs Between(const Planar<Sides> &from,
                                                     const Planar<Sides> &to, const Mask &seen) {
        using T = ScalarOf<Sides>;
        constexpr T least = std::numeric_limits<T>::min();
        const Sides fromSqr = Dot(from, from), toSqr = Dot(to, to);
        const Sides fromLength = Sqrt(fromSqr), toLength = Sqrt(toSqr);
        // All times both lengths. What is not finite is not selected.
        const Sides one = fromLength * toLength, onePlusSine = one + Cross(from, to);
        const Sides scale = T(0.5) * (RsqrtApprox(one) * RsqrtApprox(onePlusSine));
        const Planar<Sides> a{from.n * toLength, from.x * toLength};
        const Planar<Sides> b{to.n * fromLength, to.x * fromLength};
        const auto valid = seen & (fromSqr > least) & (toSqr > least);
        return {{Select(valid, (a.n + b.n + b.x - a.x) * scale, Sides(1)),
                 Select(valid, (a.x + b.x + a.n - b.n) * scale, Sides(0))},
                Select(valid, (onePlusSine - Dot(from, to)) * scale, Sides(0))};
    }
};

/// The arc of each segment that both directions see, on the ellipse with axes 1 and `squash`
/// half-way between the circle of e and that of the normals: there fringes and vanishing cosines
/// are spread evenly, and the same error takes half of the points. `g` is the sum of the unit
/// vectors towards both directions; first and last point seen from either, as borne along g.
template <class V, class U>
[[gnu::always_inline]] inline CommonArcs<V> CommonArcsOf(const Planar<V> &g,
                                                         const Bearing<V> &firstO,
                                                         const Bearing<V> &firstI,
                                                         const Bearing<V> &lastO,
                                                         const Bearing<V> &lastI, const U &squash) {
    using T = ScalarOf<V>;
    constexpr T opposite = T(1e-3);  // nearly opposite directions share nothing that counts
    const Bearing<V> first = Choose(Before(firstO, firstI), firstI, firstO);
    const Bearing<V> last = Choose(Before(lastI, lastO), lastI, lastO);
    return CommonArcs<V>::Between({first.point.n, squash * first.point.x},
                                  {last.point.n, squash * last.point.x},
                                  Before(first, last) & (Dot(g, g) > V(2 * opposite)));
}

/// Least `along` of a Bearing (less counts as at a right angle), and 1 / reach.
template <class V>
struct BearingScale {
    V least, perReach;
    [[gnu::always_inline]] explicit BearingScale(const RowView<V> &view)
        : least(ScalarOf<V>(1e-6) * view.reach * view.reach),
          perReach(RcpApprox(Max(view.reach, V(ScalarOf<V>(1e-18))))) {}
};

/// Arcs that both halves of Sides see; both halves of the result are the same.
template <class Sides, std::floating_point T>
[[gnu::always_inline]] inline CommonArcs<Sides> SeenByBoth(const SegmentViews<Sides> &views,
                                                           T squash) {
    const RowView<Sides> &view = views.seen;
    // What faces both directions is within a right angle of g; tangents are compared.
    const BearingScale<Sides> scale(view);
    const Sides u_n = view.image.n * scale.perReach, u_x = view.image.x * scale.perReach;
    const Planar<Sides> g{u_n + SwapHalves(u_n), u_x + SwapHalves(u_x)};
    using At = Bearing<Sides>;
    const At first = At::Of(g, views.first, scale.least), last = At::Of(g, views.last, scale.least);
    return CommonArcsOf(g, first, first.OtherSide(), last, last.OtherSide(), squash);
}
/// The same for two directions in vectors of their own, element by element.
template <class V>
[[gnu::always_inline]] inline CommonArcs<V> SeenByBoth(const SegmentViews<V> &o,
                                                       const SegmentViews<V> &i, const V &squash) {
    const BearingScale<V> scaleO(o.seen), scaleI(i.seen);
    const Planar<V> g{o.seen.image.n * scaleO.perReach + i.seen.image.n * scaleI.perReach,
                      o.seen.image.x * scaleO.perReach + i.seen.image.x * scaleI.perReach};
    using At = Bearing<V>;
    return CommonArcsOf(g, At::Of(g, o.first, scaleO.least), At::Of(g, i.first, scaleI.least),
                        At::Of(g, o.last, scaleO.least), At::Of(g, i.last, scaleI.least), squash);
}

/// Data of each segment that the nodes of a rule need.
template <class V>
class PigmentNodes {
  public:
    /// `share`: the segment's weight times the chord. U: V, or a scalar for all.
    template <class U>
    [[gnu::always_inline]] PigmentNodes(const Planar<V> &middle, const V &chord, const V &share,
                                        const Planar<V> &axesO, const Planar<V> &axesI,
                                        const U &aspect, const U &squash)
        : middle{middle.n, middle.x},
          stretched{middle.n * (1 / squash), middle.x * (1 / squash)},
          axesO{axesO.n, axesO.x * aspect},
          axesI{axesI.n, axesI.x * aspect},
          chord(chord),
          share(share),
          aspectSqr(aspect * aspect) {}

    /// Squared cosines to both directions, and the weight with all else that the film does not
    /// change.
    struct Values {
        V cosSqrO, cosSqrI, weight;
    };
    template <class U>
    [[gnu::always_inline]] Values At(const U &point, const U &weight) const {
        const V q = chord * point, alongSqr = 1 - q * q, perAlong = RsqrtApprox(alongSqr);
        const V along = alongSqr * perAlong;
        const V n = along * middle.n - q * middle.x, x = along * stretched.x + q * stretched.n;
        // Squared lengths of the point and of its normal; cosines times the latter's root.
        const V nSqr = n * n, xSqr = x * x, length = nSqr + xSqr, normal = aspectSqr * xSqr + nSqr;
        const V o = Max(V(0), axesO.n * n + axesO.x * x), i = Max(V(0), axesI.n * n + axesI.x * x);
        const V perNormal = RcpApprox(normal);
        return {o * o * perNormal, i * i * perNormal,
                (share * weight) * (o * i) *
                    (perAlong * RsqrtApprox((length * normal) * (length * length)))};
    }

  private:
    Planar<V> middle, stretched, axesO, axesI;
    V chord, share, aspectSqr;
};

}  // namespace pbrt::feather
