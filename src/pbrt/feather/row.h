#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <tuple>

#include "../simd/math.h"
#include "../simd/trig.h"
#include "direction.h"
#include "units.h"

namespace pbrt::feather {

/// Part of a row that one in-plane direction w (or each of several) sees: on every unit circle the
/// points E with E.u > 0 and q = E.t in [lower, upper] / reach, u being the unit vector along
/// `image` and t u turned by +90 degrees. All is times `reach`, which saves dividing by it.
template <class V>
struct RowView {
    Planar<V> image;  ///< of w under the affine map
    V reach;          ///< its length
    V shift;          ///< |D| reach, D the distance between neighbouring circles across the beam
    V lower, upper;   ///< an end at -reach or reach exactly is a silhouette

    /// Share of the beam that passes between the barbules.
    V Gap() const {
        const V passed = shift - 2 * reach;
        return Select(passed > 0, passed / shift, V(0));
    }

    /// reach^2 times the point of the circle at height q / reach, on the side that faces w.
    [[gnu::always_inline]] Planar<V> ScaledPointAt(const V &q) const {
        const V along = Sqrt(Max(V(0), (reach - q) * (reach + q)));
        return {along * image.n - q * image.x, along * image.x + q * image.n};
    }
    /// The point itself, reach > 0.
    Planar<V> PointAt(const V &q) const {
        const V scale = 1 / reach;
        const RowView unit{{image.n * scale, image.x * scale}, V(1), V(0), V(0), V(0)};
        return unit.ScaledPointAt(q * scale);
    }

    /// True where w sees the point along `e` (any length; `length` is its length).
    MaskFor<V> Sees(const Planar<V> &e, const V &length) const {
        const V q = Cross(image, e);
        return (Dot(image, e) > 0) & ((lower == -reach) | (q >= lower * length)) &
               ((upper == reach) | (q <= upper * length));
    }
};

/// An interval, empty unless lo < hi.
template <class T>
struct Interval {
    T lo, hi;
};

/// An endless row of parallel elliptical cylinders (MODEL sections 4.1 and 4.2), seen across.
///
/// The affine map A = diag(1/b, 1) R(-tilt) makes every ellipse a unit circle and keeps what hides
/// what. Exact for every spacing, touching and interpenetrating barbules included.
template <class V>
class Row {
  public:
    Row() = default;
    Row(V spacing, Radian<V> tilt, V aspect) requires std::floating_point<V>
        : spacing(spacing),
          aspect(aspect),
          cosTilt(std::cos(tilt.value)),
          sinTilt(std::sin(tilt.value)),
          inverseAspect(1 / aspect),
          stride(spacing / aspect),
          step{stride * sinTilt, spacing *cosTilt},
          stepSqr(Dot(step, step)),
          midSlope(std::sqrt(std::max(V(0), 1 / stepSqr - V(0.25)))),
          squash(std::clamp(std::sqrt(aspect), V(0.4), V(2.5))) {}

    /// Gives the barbules another tilt, where asked to. float: sines to 1.5e-7.
    void Tilt(const MaskFor<V> &where, const Radian<V> &tilt) {
        using T = ScalarOf<V>;
        const auto [sine, cosine] = SinCosTurns(V(tilt.value * T(0.5 * std::numbers::inv_pi)));
        const Planar<V> stepThere{stride * sine, spacing * cosine};
        const V sqr = Dot(stepThere, stepThere);
        cosTilt = Select(where, cosine, cosTilt);
        sinTilt = Select(where, sine, sinTilt);
        step = Select(where, stepThere, step);
        stepSqr = Select(where, sqr, stepSqr);
        midSlope = Select(where, Sqrt(Max(V(0), 1 / sqr - V(T(0.25)))), midSlope);
    }

    V Spacing() const { return spacing; }
    V Aspect() const { return aspect; }
    /// The other semi-axis of the ellipse, one being 1, on which TRT is integrated: half-way from
    /// the circle of e to that of the normals.
    V Squash() const { return squash; }

    /// All that a row consists of, see fields.h.
    auto Fields() { return FieldsOf(*this); }
    auto Fields() const { return FieldsOf(*this); }

    /// Barbules touch or interpenetrate: no direction sees a gap.
    MaskFor<V> Closed() const { return stepSqr <= 4; }

    /// An in-plane vector turned into the frame of the ellipse's axes, and back.
    template <class U>
    [[gnu::always_inline]] Planar<U> ToAxes(const Planar<U> &w) const {
        return {cosTilt * w.n + sinTilt * w.x, cosTilt * w.x - sinTilt * w.n};
    }
    Planar<V> FromAxes(const Planar<V> &w) const {
        return {cosTilt * w.n - sinTilt * w.x, sinTilt * w.n + cosTilt * w.x};
    }

    /// Part of the row that the in-plane direction w (any length; zero sees nothing) sees.
    ///
    /// With D = v.t and z = v.u for the step v from circle to circle, |D| < 2 and s = sign(D):
    /// neighbours cross in a visible point when 2|D| > |v|^2 (this is |z| < G of MODEL 4.2,
    /// squared) and cut [-1, 1] at +-|D|/2 - s z sqrt(1/|v|^2 - 1/4); else the one in front hides
    /// all that it overlaps, and |D| is left at the other end.
    template <class U = V>
    [[gnu::always_inline]] RowView<U> SeenFrom(const Planar<U> &w) const {
        using T = ScalarOf<V>;
        const Beam<U> b = BeamAlong(w);
        const U middle = -midSlope * b.z, half = b.shift * T(0.5);
        // Selected, not branched to: several directions have all cases at once.
        const auto whole = b.shift >= 2 * b.reach, cross = 2 * b.shift > stepSqr * b.reach,
                   upperHidden = b.z > 0;
        const U lower =
            Select(cross, middle - half, Select(upperHidden, -b.reach, b.reach - b.shift));
        const U upper =
            Select(cross, middle + half, Select(upperHidden, b.shift - b.reach, b.reach));
        return {b.image, b.reach, b.shift, Select(whole, -b.reach, lower),
                Select(whole, b.reach, upper)};
    }

    /// The point half-way across what w sees, times reach^2, and reach^2. The middle of SeenFrom's
    /// interval, found without its ends.
    struct Middle {
        Planar<V> point;
        V reachSqr;
    };
    Middle MiddleSeenFrom(const Planar<V> &w) const {
        const Beam<V> b = BeamAlong(w);
        const V beside = Max(V(0), b.reach - b.shift * ScalarOf<V>(0.5));
        const V middle =
            Select(2 * b.shift > stepSqr * b.reach, midSlope * b.z, MulSign(beside, b.z));
        const RowView<V> view{b.image, b.reach, b.shift, V(0), V(0)};
        return {view.ScaledPointAt(-middle), b.reach * b.reach};
    }

    /// Share of the light along the in-plane direction w that passes: max(0, 1 - 2/|D|).
    V Gap(Planar<V> w) const {
        const Planar<V> axes = ToAxes(w);
        const V across = std::sqrt(axes.n * axes.n + aspect * aspect * axes.x * axes.x);
        const V passed = spacing * std::abs(w.n) - 2 * across;
        return passed > 0 ? passed / (spacing * std::abs(w.n)) : V(0);
    }

    /// The |w_n| at which a direction with the given w_x sees a gap; w_n w_x has the sign of
    /// `side`. The ends are the roots of |D| = 2, a quadratic form in (w_n, w_x); (inf, inf) if
    /// there is none.
    Interval<V> Open(V absX, V side) const {
        constexpr V infinity = std::numeric_limits<V>::infinity();
        if (Closed()) return {infinity, infinity};
        // b^2 h^2 = a w_n^2 + 2 b w_n w_x + c w_x^2 with a c - b^2 = aspect^2
        const V c = sinTilt * sinTilt + aspect * aspect * cosTilt * cosTilt;
        const V b = std::copysign(V(1), side) * sinTilt * cosTilt * (1 - aspect * aspect);
        const V root = aspect * std::sqrt(stepSqr - 4) / 2;
        return {root > b ? absX * c / (root - b) : infinity,
                -b > root ? absX * c / (-b - root) : infinity};
    }

  private:
    /// A direction under the affine map, and the next circle as seen along it.
    template <class U>
    struct Beam {
        Planar<U> image;
        U reach, shift;  ///< as RowView's
        U z;             ///< z reach, times the sign of D
    };
    template <class U>
    [[gnu::always_inline]] Beam<U> BeamAlong(const Planar<U> &w) const {
        const Planar<U> axes = ToAxes(w);
        const U n = axes.n * inverseAspect, x = axes.x, d = stride * w.n;
        return {{n, x}, Sqrt(n * n + x * x), Abs(d), MulSign(step.n * n + step.x * x, d)};
    }

    template <class Self>
    static auto FieldsOf(Self &r) {
        return std::tie(r.spacing, r.aspect, r.cosTilt, r.sinTilt, r.inverseAspect, r.stride,
                        r.step.n, r.step.x, r.stepSqr, r.midSlope, r.squash);
    }

    V spacing, aspect, cosTilt, sinTilt;
    V inverseAspect, stride;  ///< 1 / aspect, spacing / aspect
    Planar<V> step;           ///< from one circle to the next
    V stepSqr;                ///< its squared length, L^2
    V midSlope;               ///< sqrt(1/L^2 - 1/4), or 0
    V squash;
};

}  // namespace pbrt::feather
