#pragma once

#include "pbrt/simd/permute.h"
#include "pbrt/util/math.h"

namespace pbrt {

// The one-dimensional distributions of the hair model, four lobes at a time.

/// Densities fall to e^kFloor = 3e-17 of their peak and no further: products of two of them then
/// are not denormal, which would be ten times slower.
inline constexpr float kFloor = -38;

/// Azimuths about a fibre: the logistic distribution of scale s, cut off at -pi and pi.
class TrimmedLogistic {
  public:
    explicit TrimmedLogistic(float s) : s(s), mass(std::tanh(Pi / (2 * s))), peak(1 / (s * mass)) {}

    /// Density of an angle in [-pi, pi].
    FloatX4 PDF(FloatX4 x) const {
        const FloatX4 e = Exp(Max(Abs(x) * (-1 / s), kFloor));
        return peak * e / ((1 + e) * (1 + e));
    }
    /// The angle at which the cumulated density is u in [0, 1); to within 2^-25 of the mass at each
    /// end, beyond which no float u lies.
    float Sample(float u) const {
        const float t = std::clamp((2 * u - 1) * mass, -OneMinusEpsilon, OneMinusEpsilon);
        return std::clamp(s * (std::log1p(t) - std::log1p(-t)), -Pi, Pi);
    }

  private:
    float s, mass, peak;
};

/// A direction's angle with the plane normal to the fibre.
struct Inclination {
    FloatX4 sin, cos;
};

/// Inclinations of scattered light: d'Eon et al. 2011, "An Energy-Conserving Hair Reflectance
/// Model", eq. 7: exp(-sin_i sin_o / v) I0(cos_i cos_o / v) / (2 v sinh(1 / v)), a density with
/// respect to sin_i, one variance v for each lobe.
///
/// Evaluated as e^E (e^-a I0(a)) / (v (1 - e^(-2/v))) with a = cos_i cos_o / v and
/// E = (cos(i + o) - 1) / v = -((cos_i - cos_o)^2 + (sin_i + sin_o)^2) / (2 v): nothing overflows
/// or cancels however small v is. Relative error 1e-6 for v >= 1e-5 and unit (sin, cos).
class Longitudinal {
  public:
    explicit Longitudinal(FloatX4 variance)
        : v(variance),
          inverse(1 / variance),
          tail(Exp(-2 * inverse)),
          scale(inverse / (1 - tail)) {}

    FloatX4 PDF(Inclination i, Inclination o) const {
        const FloatX4 a = i.cos * o.cos * inverse;
        const FloatX4 dCos = i.cos - o.cos, dSin = i.sin + o.sin;
        const FloatX4 E = (dCos * dCos + dSin * dSin) * (-0.5f * inverse);
        // I0 by two polynomials, own minimax fits, relative error 1.2e-7: in (a / 5)^2 below 5,
        // where the factor e^-a goes into the exponent, and in 5 / a above.
        const auto isSmall = a < 5;
        const FloatX4 below = Min(a * a * 0.04f, 1), above = 5 / Max(a, 5);
        const FloatX4 small =
            EvaluatePolynomial(below, 0.999999991f, 6.25000188f, 9.76556959f, 6.78226123f,
                               2.64630752f, 0.669258604f, 0.105675354f, 0.020797392f);
        const FloatX4 large =
            EvaluatePolynomial(above, 0.398942237f, 0.00997722117f, 0.00107175338f, 0.000483097047f,
                               -0.000473671231f, 0.000547792264f, -0.000138651963f) *
            Sqrt(above * 0.2f);
        return Exp(Max(Select(isSmall, E - a, E), kFloor)) * Select(isSmall, small, large) * scale;
    }

    /// Sine and cosine of the incident inclination drawn for one lobe; u in [0, 1)^2. d'Eon et al.
    /// 2013, "Importance Sampling for Physically-Based Hair Fiber Models".
    Point2f Sample(int lobe, float sin_o, float cos_o, Point2f u) const {
        // u.x of 0 to 1 excluded is 1 - w with w in (0, 1], so the logarithm exists. 1 - cos, so
        // that small angles keep their digits.
        const float w = 1 - u.x;
        const float d = std::min(2.f, -v[lobe] * std::log(w + (1 - w) * tail[lobe]));
        const float r = SafeSqrt(d * (2 - d)), cosPhi = SinCosTurns(u.y).cos;
        const float sin_i = -(1 - d) * sin_o + r * cosPhi * cos_o;
        return {std::clamp(sin_i, -1.f, 1.f), SafeSqrt(1 - Sqr(sin_i))};
    }

  private:
    FloatX4 v, inverse, tail, scale;
};

}  // namespace pbrt
