#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "direction.h"
#include "units.h"

namespace pbrt::feather {

/// What one in-plane direction w sees of a row: on every unit circle the points E with E.u > 0
/// and q = E.t in [lower, upper], t being u turned by +90 degrees.
template <std::floating_point T>
struct RowView {
    Planar<T> u;     ///< unit direction of w on the circle
    T reach;         ///< length of w's image under the affine map
    T shift;         ///< |D|, distance between neighbouring circles across the beam
    T lower, upper;  ///< upper - lower = min(2, shift); an end at -1 or 1 exactly is a silhouette

    /// Share of the beam that passes between the barbules.
    T Gap() const { return shift > 2 ? (shift - 2) / shift : T(0); }

    /// The point of the circle at height q across the beam, on the side that faces w.
    [[gnu::always_inline]] Planar<T> PointAt(T q) const {
        const T along = std::sqrt(std::max(T(0), 1 - q * q));
        return {along * u.n - q * u.x, along * u.x + q * u.n};
    }

    /// Whether w sees the point along `e` (any length; `length` is its length).
    bool Sees(Planar<T> e, T length) const {
        const T q = Cross(u, e);
        return Dot(u, e) > 0 && (lower == -1 || q >= lower * length) &&
               (upper == 1 || q <= upper * length);
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
    [[gnu::always_inline]] Planar<T> ToAxes(Planar<T> w) const {
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
    [[gnu::always_inline]] RowView<T> SeenFrom(Planar<T> w) const {
        const Planar<T> axes = ToAxes(w), image{axes.n * inverseAspect, axes.x};
        const T reach = std::sqrt(Dot(image, image));
        const T scale = 1 / std::max(reach, kNoReach);
        const Planar<T> u{image.n * scale, image.x * scale};
        const T d = stride * w.n * scale;
        const T shift = std::abs(d), z = std::copysign(T(1), d) * Dot(step, u);
        const T middle = -midSlope * z;
        // Selected, not branched to: the loops over segments run in vector registers.
        const bool whole = shift >= 2, cross = 2 * shift > stepSqr, upperHidden = z > 0;
        const T lower = cross ? middle - shift / 2 : upperHidden ? T(-1) : 1 - shift;
        const T upper = cross ? middle + shift / 2 : upperHidden ? shift - 1 : T(1);
        return {u, reach, shift, whole ? T(-1) : lower, whole ? T(1) : upper};
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
