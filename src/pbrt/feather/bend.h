#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <tuple>

#include "../simd/math.h"
#include "arc.h"
#include "direction.h"
#include "row.h"
#include "units.h"

namespace pbrt::feather {

/// A segment of a bent barbule, by its bend angle a in (-pi/2, pi/2); its normal is (0, sin a, cos
/// a).
template <class V>
struct Segment {
    V sin, cos;

    /// The direction w in the plane across the segment.
    [[gnu::always_inline]] Planar<V> Across(const Direction<V> &w) const {
        return {w.y * sin + w.z * cos, w.x};
    }
};

/// The circular arc along a barbule: a chain of straight rows (MODEL section 4.3).
///
/// A segment takes the share da / (2 sin opening) of the vane's area, and counts with
/// |w.z_a| / |w.z| for a direction w. With s = |w.y| cos a' - |w.z| sin a' (a' is a, turned so that
/// a' = opening is the end nearest w) the weight is uniform in s, over
/// |w.y| cos opening -+ |w.z| sin opening: this also where the arc's rim hides a part of it.
template <class V>
class Bend {
  public:
    /// A smaller opening counts as this one: a straight row would reflect into a delta.
    static constexpr ScalarOf<V> kLeastOpening = ScalarOf<V>(1e-3);

    Bend() = default;
    explicit Bend(Radian<V> halfAngle) requires std::floating_point<V>
        : opening(std::max(halfAngle.value, kLeastOpening)),
          sinOpening(std::sin(opening)),
          cosOpening(std::cos(opening)),
          halfTangent(sinOpening / (1 + cosOpening)) {}

    V Opening() const { return opening; }
    V SinOpening() const { return sinOpening; }

    /// All that a bend consists of, see fields.h.
    auto Fields() { return std::tie(opening, sinOpening, cosOpening, halfTangent); }
    auto Fields() const { return std::tie(opening, sinOpening, cosOpening, halfTangent); }

    /// +1 if w is nearest the end at +opening, else -1.
    static V Side(const Direction<V> &w) { return SignOf(w.y) * SignOf(w.z); }

    /// True where the segment is part of the arc and w sees it; cos a >= 0.
    /// float: the range's end is off by up to 1e-7 rad.
    MaskFor<V> Sees(const Direction<V> &w, const Segment<V> &a) const {
        const V sinNear = Side(w) * a.sin;  // of a'
        const V sinXi = sinOpening * a.cos - cosOpening * sinNear;
        const V cosXi = cosOpening * a.cos + sinOpening * sinNear;
        return (Abs(a.sin) <= sinOpening) & (sinXi * Abs(w.y) <= Abs(w.z) * (1 + cosXi));
    }

    /// False only if no facet of the arc has a normal along m (of any length): most pairs of
    /// directions end here, before anything is divided. A little too wide, for rounding.
    MaskFor<V> MayHaveNormal(const Direction<V> &m) const {
        using T = ScalarOf<V>;
        constexpr T slack = 1 + 8 * std::numeric_limits<T>::epsilon();
        return m.y * m.y <= slack * sinOpening * sinOpening * (m.y * m.y + m.z * m.z);
    }

    /// The bend angles that w sees.
    Interval<V> SeenFrom(Direction<V> w) const {
        const V absY = std::abs(w.y), absZ = std::abs(w.z);
        if (SeesAll(w)) return {-opening, opening};
        const V width = std::min(2 * opening, 2 * std::atan2(absZ, absY));
        return Side(w) > 0 ? Interval<V>{opening - width, opening}
                           : Interval<V>{-opening, width - opening};
    }

    /// The bend angles that both directions see, as an arc of points (cos a, sin a), where there
    /// are any; SeenFrom without trigonometric functions.
    struct Shared {
        Arc<V> arc;
        MaskFor<V> any;
    };
    [[gnu::always_inline]] Shared SeenByBoth(const Direction<V> &wo, const Direction<V> &wi) const {
        const MaskFor<V> all = SeesAll(wo) & SeesAll(wi);
        const Arc<V> whole{{V(1), V(0)}, halfTangent};
        if (All(all)) return {whole, all};
        const Interval<Planar<V>> o = Ends(wo), i = Ends(wi);
        const Planar<V> from = Select(o.lo.x > i.lo.x, o.lo, i.lo),
                        to = Select(o.hi.x < i.hi.x, o.hi, i.hi);
        const Arc<V> arc = Arc<V>::Between(from, to);
        return {{Select(all, whole.middle, arc.middle), Select(all, halfTangent, arc.tangent)},
                from.x < to.x};
    }

    /// The ends of the range of s for w, as (|w.z_a|, s); neither is the other's cancelled root.
    Interval<Planar<V>> Weights(Direction<V> w) const {
        const V y = std::abs(w.y), z = std::abs(w.z);
        return {{z * cosOpening + y * sinOpening, y * cosOpening - z * sinOpening},
                {std::abs(z * cosOpening - y * sinOpening), y * cosOpening + z * sinOpening}};
    }

    /// The segment that halves what w, w.z != 0, sees of the arc: Sample's for u = 1/2.
    struct Middle {
        Planar<V> normal;  ///< times r^2: cosine and sine of its bend angle
        V rSqr;            ///< w.y^2 + w.z^2
        V along;           ///< w.z_a
    };
    Middle MiddleSeenFrom(const Direction<V> &w) const {
        const V absY = Abs(w.y), absZ = Abs(w.z);
        const V s = absY * cosOpening, h = absY * sinOpening, c = Sqrt(absZ * absZ + h * h);
        return {{absZ * c + absY * s, Side(w) * (absY * c - absZ * s)},
                absY * absY + absZ * absZ,
                SignOf(w.z) * c};
    }

    /// Draws a segment in proportion to its weight for w, w.z != 0, from u in [0, 1).
    Segment<V> Sample(const Direction<V> &w, const V &u) const {
        // In turns of (|w.z|, |w.y|) = r (cos t, sin t): s = r sin(t - a'), here from a' = opening.
        const V absY = Abs(w.y), absZ = Abs(w.z);
        const V rSqr = absY * absY + absZ * absZ;
        const V s0 = absY * cosOpening - absZ * sinOpening;
        const V c0 = absZ * cosOpening + absY * sinOpening;
        const V ds = 2 * absZ * sinOpening * u, s = s0 + ds;
        // sqrt(r^2 - s^2), from the sum that does not cancel
        const V c = Sqrt(Max(V(0), c0 * c0 - ds * (s0 + s)));
        const V scale = 1 / rSqr;
        return {Side(w) * (absY * c - absZ * s) * scale, (absZ * c + absY * s) * scale};
    }

  private:
    MaskFor<V> SeesAll(const Direction<V> &w) const {
        return Abs(w.y) * sinOpening <= Abs(w.z) * cosOpening;
    }

    [[gnu::always_inline]] Interval<Planar<V>> Ends(const Direction<V> &w) const {
        const Planar<V> plus{cosOpening, sinOpening}, minus{cosOpening, -sinOpening};
        const V y = Abs(w.y), z = Abs(w.z), perSqr = 1 / (y * y + z * z);
        const V cosWidth = (y * y - z * z) * perSqr, sinWidth = 2 * y * z * perSqr;
        const Planar<V> far{cosOpening * cosWidth + sinOpening * sinWidth,
                            sinOpening * cosWidth - cosOpening * sinWidth};
        const MaskFor<V> all = SeesAll(w), nearPlus = Side(w) > 0;
        return {Select(all | !nearPlus, minus, far),
                Select(all | nearPlus, plus, Planar<V>{far.n, -far.x})};
    }

    V opening, sinOpening, cosOpening;
    V halfTangent;  ///< tan(opening / 2)
};

}  // namespace pbrt::feather
