#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "direction.h"
#include "pack.h"
#include "units.h"

namespace pbrt::feather {

/// What one in-plane direction w (or each of a Pack) sees of a row: on every unit circle the points
/// E with E.u > 0 and q = E.t in [lower, upper] / reach, u being the unit vector along `image` and
/// t u turned by +90 degrees. All is times `reach`, which saves dividing by it.
template <class V>
struct RowView {
    Planar<V> image;  ///< of w under the affine map
    V reach;          ///< its length
    V shift;          ///< |D| reach, D the distance between neighbouring circles across the beam
    V lower, upper;   ///< an end at -reach or reach exactly is a silhouette

    /// Share of the beam that passes between the barbules.
    V Gap() const { return shift > 2 * reach ? (shift - 2 * reach) / shift : V(0); }

    /// reach^2 times the point of the circle at height q / reach, on the side that faces w.
    [[gnu::always_inline]] Planar<V> ScaledPointAt(const V &q) const {
        const V along = Sqrt(Max(V(0), (reach - q) * (reach + q)));
        return {along * image.n - q * image.x, along * image.x + q * image.n};
    }
    /// The point itself, reach > 0.
    Planar<V> PointAt(V q) const {
        const V scale = 1 / reach;
        const RowView unit{{image.n * scale, image.x * scale}, 1, 0, 0, 0};
        return unit.ScaledPointAt(q * scale);
    }

    /// Whether w sees the point along `e` (any length; `length` is its length).
    bool Sees(Planar<V> e, V length) const {
        const V q = Cross(image, e);
        return Dot(image, e) > 0 && (lower == -reach || q >= lower * length) &&
               (upper == reach || q <= upper * length);
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
template <std::floating_point T>
class Row {
  public:
    Row() = default;
    Row(T spacing, Radian<T> tilt, T aspect)
        : spacing(spacing),
          aspect(aspect),
          cosTilt(std::cos(tilt.value)),
          sinTilt(std::sin(tilt.value)),
          inverseAspect(1 / aspect),
          stride(spacing / aspect),
          step{stride * sinTilt, spacing * cosTilt},
          stepSqr(Dot(step, step)),
          midSlope(std::sqrt(std::max(T(0), 1 / stepSqr - T(0.25)))) {}

    T Spacing() const { return spacing; }
    T Aspect() const { return aspect; }

    /// Barbules touch or interpenetrate: no direction sees a gap.
    bool Closed() const { return stepSqr <= 4; }

    /// An in-plane vector turned into the frame of the ellipse's axes, and back.
    template <class V>
    [[gnu::always_inline]] Planar<V> ToAxes(const Planar<V> &w) const {
        return {cosTilt * w.n + sinTilt * w.x, cosTilt * w.x - sinTilt * w.n};
    }
    Planar<T> FromAxes(Planar<T> w) const {
        return {cosTilt * w.n - sinTilt * w.x, sinTilt * w.n + cosTilt * w.x};
    }

    /// What the in-plane direction w (any length; zero sees nothing) sees of the row.
    ///
    /// With D = v.t and z = v.u for the step v from circle to circle, |D| < 2 and s = sign(D):
    /// neighbours cross in a visible point when 2|D| > |v|^2 (this is |z| < G of MODEL 4.2,
    /// squared) and cut [-1, 1] at +-|D|/2 - s z sqrt(1/|v|^2 - 1/4); else the one in front hides
    /// all that it overlaps, and |D| is left at the other end.
    template <class V = T>
    [[gnu::always_inline]] RowView<V> SeenFrom(const Planar<V> &w) const {
        const Planar<V> axes = ToAxes(w);
        const V n = axes.n * inverseAspect, x = axes.x, reach = Sqrt(n * n + x * x);
        const V d = stride * w.n, shift = Abs(d), z = SignOf(d) * (step.n * n + step.x * x);
        const V middle = -midSlope * z, half = shift * T(0.5);
        // Selected, not branched to: a Pack has all cases at once.
        const auto whole = shift >= 2 * reach, cross = 2 * shift > stepSqr * reach,
                   upperHidden = z > 0;
        const V lower = Select(cross, middle - half, Select(upperHidden, -reach, reach - shift));
        const V upper = Select(cross, middle + half, Select(upperHidden, shift - reach, reach));
        return {{n, x}, reach, shift, Select(whole, -reach, lower), Select(whole, reach, upper)};
    }

    /// Share of the light along the in-plane direction w that passes: max(0, 1 - 2/|D|).
    T Gap(Planar<T> w) const {
        const Planar<T> axes = ToAxes(w);
        const T across = std::sqrt(axes.n * axes.n + aspect * aspect * axes.x * axes.x);
        const T passed = spacing * std::abs(w.n) - 2 * across;
        return passed > 0 ? passed / (spacing * std::abs(w.n)) : T(0);
    }

    /// The |w_n| at which a direction with the given w_x sees a gap; w_n w_x has the sign of
    /// `side`. The ends are the roots of |D| = 2, a quadratic form in (w_n, w_x); (inf, inf) if
    /// there is none.
    Interval<T> Open(T absX, T side) const {
        constexpr T infinity = std::numeric_limits<T>::infinity();
        if (Closed()) return {infinity, infinity};
        // b^2 h^2 = a w_n^2 + 2 b w_n w_x + c w_x^2 with a c - b^2 = aspect^2
        const T c = sinTilt * sinTilt + aspect * aspect * cosTilt * cosTilt;
        const T b = std::copysign(T(1), side) * sinTilt * cosTilt * (1 - aspect * aspect);
        const T root = aspect * std::sqrt(stepSqr - 4) / 2;
        return {root > b ? absX * c / (root - b) : infinity,
                -b > root ? absX * c / (-b - root) : infinity};
    }

  private:
    /// Below this a direction counts as along the barbule; its square is still normal in float.
    static constexpr T kNoReach = T(1e-18);

    T spacing, aspect, cosTilt, sinTilt;
    T inverseAspect, stride;  ///< 1 / aspect, spacing / aspect
    Planar<T> step;           ///< from one circle to the next
    T stepSqr;                ///< its squared length, L^2
    T midSlope;               ///< sqrt(1/L^2 - 1/4), or 0
};

}  // namespace pbrt::feather
