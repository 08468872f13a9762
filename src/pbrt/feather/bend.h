#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "arc.h"
#include "direction.h"
#include "pack.h"
#include "row.h"
#include "units.h"

namespace pbrt::feather {

/// A segment of a bent barbule, by its bend angle a in (-pi/2, pi/2); its normal is (0, sin a, cos
/// a).
template <std::floating_point T>
struct Segment {
    T sin, cos;

    /// The direction w in the plane across the segment.
    [[gnu::always_inline]] Planar<T> Across(Direction<T> w) const {
        return {w.y * sin + w.z * cos, w.x};
    }
};

/// The circular arc along a barbule: a chain of straight rows (MODEL section 4.3).
///
/// A segment takes the share da / (2 sin opening) of the vane's area, and counts with
/// |w.z_a| / |w.z| for a direction w. With s = |w.y| cos a' - |w.z| sin a' (a' is a, turned so that
/// a' = opening is the end nearest w) the weight is uniform in s, over
/// |w.y| cos opening -+ |w.z| sin opening: this also where the arc's rim hides a part of it.
template <std::floating_point T>
class Bend {
  public:
    /// A smaller opening counts as this one: a straight row would reflect into a delta.
    static constexpr T kLeastOpening = T(1e-3);

    Bend() = default;
    explicit Bend(Radian<T> halfAngle)
        : opening(std::max(halfAngle.value, kLeastOpening)),
          sinOpening(std::sin(opening)),
          cosOpening(std::cos(opening)),
          halfTangent(sinOpening / (1 + cosOpening)) {}

    T Opening() const { return opening; }
    T SinOpening() const { return sinOpening; }

    /// +1 if w is nearest the end at +opening, else -1.
    static T Side(Direction<T> w) { return SignOf(w.y) * SignOf(w.z); }

    /// Whether the segment is part of the arc and w sees it; cos a >= 0.
    /// float: the range's end is off by up to 1e-7 rad.
    bool Sees(Direction<T> w, Segment<T> a) const {
        const T sinNear = Side(w) * a.sin;  // of a'
        const T sinXi = sinOpening * a.cos - cosOpening * sinNear;
        const T cosXi = cosOpening * a.cos + sinOpening * sinNear;
        return std::abs(a.sin) <= sinOpening &&
               sinXi * std::abs(w.y) <= std::abs(w.z) * (1 + cosXi);
    }

    /// False only if no facet of the arc has a normal along m (of any length): most pairs of
    /// directions end here, before anything is divided. A little too wide, for rounding.
    bool MayHaveNormal(Direction<T> m) const {
        constexpr T slack = 1 + 8 * std::numeric_limits<T>::epsilon();
        return m.y * m.y <= slack * sinOpening * sinOpening * (m.y * m.y + m.z * m.z);
    }

    /// The bend angles that w sees.
    Interval<T> SeenFrom(Direction<T> w) const {
        const T absY = std::abs(w.y), absZ = std::abs(w.z);
        if (SeesAll(w)) return {-opening, opening};
        const T width = std::min(2 * opening, 2 * std::atan2(absZ, absY));
        return Side(w) > 0 ? Interval<T>{opening - width, opening}
                           : Interval<T>{-opening, width - opening};
    }

    /// The bend angles that both directions see, as an arc of points (cos a, sin a), if there are
    /// any; SeenFrom without trigonometric functions.
    std::optional<Arc<T>> SeenByBoth(const Direction<T> &wo, const Direction<T> &wi) const {
        if (SeesAll(wo) && SeesAll(wi)) return Arc<T>{{1, 0}, halfTangent};
        const Interval<Planar<T>> o = Ends(wo), i = Ends(wi);
        const Planar<T> from = o.lo.x > i.lo.x ? o.lo : i.lo, to = o.hi.x < i.hi.x ? o.hi : i.hi;
        if (!(from.x < to.x)) return {};
        return Arc<T>::Between(from, to);
    }

    /// The ends of the range of s for w, as (|w.z_a|, s); neither is the other's cancelled root.
    Interval<Planar<T>> Weights(Direction<T> w) const {
        const T y = std::abs(w.y), z = std::abs(w.z);
        return {{z * cosOpening + y * sinOpening, y * cosOpening - z * sinOpening},
                {std::abs(z * cosOpening - y * sinOpening), y * cosOpening + z * sinOpening}};
    }

    /// The segment that halves what w, w.z != 0, sees of the arc: Sample's for u = 1/2.
    struct Middle {
        Planar<T> normal;  ///< times r^2: cosine and sine of its bend angle
        T rSqr;            ///< w.y^2 + w.z^2
        T along;           ///< w.z_a
    };
    Middle MiddleSeenFrom(Direction<T> w) const {
        const T absY = std::abs(w.y), absZ = std::abs(w.z);
        const T s = absY * cosOpening, h = absY * sinOpening, c = std::sqrt(absZ * absZ + h * h);
        return {{absZ * c + absY * s, Side(w) * (absY * c - absZ * s)},
                absY * absY + absZ * absZ,
                std::copysign(c, w.z)};
    }

    /// Draws a segment in proportion to its weight for w, w.z != 0, from u in [0, 1).
    Segment<T> Sample(Direction<T> w, T u) const {
        // In turns of (|w.z|, |w.y|) = r (cos t, sin t): s = r sin(t - a'), here from a' = opening.
        const T absY = std::abs(w.y), absZ = std::abs(w.z);
        const T rSqr = absY * absY + absZ * absZ;
        const T s0 = absY * cosOpening - absZ * sinOpening;
        const T c0 = absZ * cosOpening + absY * sinOpening;
        const T ds = 2 * absZ * sinOpening * u, s = s0 + ds;
        // sqrt(r^2 - s^2), from the sum that does not cancel
        const T c = std::sqrt(std::max(T(0), c0 * c0 - ds * (s0 + s)));
        const T scale = 1 / rSqr;
        return {Side(w) * (absY * c - absZ * s) * scale, (absZ * c + absY * s) * scale};
    }

  private:
    bool SeesAll(const Direction<T> &w) const {
        return std::abs(w.y) * sinOpening <= std::abs(w.z) * cosOpening;
    }

    Interval<Planar<T>> Ends(Direction<T> w) const {
        const Planar<T> plus{cosOpening, sinOpening}, minus{cosOpening, -sinOpening};
        if (SeesAll(w)) return {minus, plus};
        const T y = std::abs(w.y), z = std::abs(w.z), rSqr = y * y + z * z;
        const T cosWidth = (y * y - z * z) / rSqr, sinWidth = 2 * y * z / rSqr;
        const Planar<T> far{cosOpening * cosWidth + sinOpening * sinWidth,
                            sinOpening * cosWidth - cosOpening * sinWidth};
        return Side(w) > 0 ? Interval<Planar<T>>{far, plus}
                           : Interval<Planar<T>>{minus, {far.n, -far.x}};
    }

    T opening, sinOpening, cosOpening;
    T halfTangent;  ///< tan(opening / 2)
};

}  // namespace pbrt::feather
