#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "math.h"

namespace pbrt {

// Sines of angles in turns: the reduction to one period is exact. Those of floats are polynomials:
// calls of the standard library would keep vectors in memory. Of double, which only references use,
// they are the standard library's.

template <class V>
struct SinCosT {
    V sin, cos;
};
using SinCos = SinCosT<float>;

/// std::sin and std::cos of angles in radians.
template <class V>
[[gnu::always_inline]] inline SinCosT<V> SinCosRadians(const V &angle) {
    if constexpr (std::floating_point<V>)
        return {std::sin(angle), std::cos(angle)};
    else
        return {MapElements([](auto e) { return std::sin(e); }, angle),
                MapElements([](auto e) { return std::cos(e); }, angle)};
}

/// Sine and cosine of r quarter turns, |r| <= 1/2. Absolute error below 1.5e-7. Sampling warps
/// know their quadrant and need no more: a third of the time of sinf and cosf. Polynomials in r^2:
/// own minimax fit.
template <AnyFloat V>
[[gnu::always_inline]] inline SinCosT<V> SinCosQuarters(const V &r) {
    const V s = r * r;
    return {
        r * EvaluatePolynomial(s, 1.57079632f, -0.645963479f, 0.0796802281f, -0.00460217700f),
        1 + s * EvaluatePolynomial(s, -1.23370055f, 0.253669410f, -0.0208615297f, 0.000906743541f)};
}

/// Sine and cosine of `turns` times 2 pi; float: |turns| <= 2^20, error as above.
template <class V>
[[gnu::always_inline]] inline SinCosT<V> SinCosTurns(const V &turns) {
    if constexpr (AnyFloat<V>) {
        const V quarter = Floor(4 * turns + 0.5f);
        const SinCosT<V> part = SinCosQuarters(V(4 * turns - quarter));
        const auto q = Convert<int32_t>(quarter);
        const auto swapped = (q & 1) != 0;
        const V sin = Select(swapped, part.cos, part.sin),
                cos = Select(swapped, part.sin, part.cos);
        return {Select((q & 2) != 0, V(-sin), sin), Select(((q + 1) & 2) != 0, V(-cos), cos)};
    } else {
        return SinCosRadians(V(2 * std::numbers::pi * (turns - Round(turns))));
    }
}

/// sin^2(pi turns), for any finite number of turns.
/// float: polynomial, 2e-7 relative to the exact value of the rounded argument.
template <class V>
[[gnu::always_inline]] inline V SinSquaredPi(const V &turns) {
    using T = ScalarOf<V>;
    const V x = turns - Round(turns);
    if constexpr (!AnyFloat<V>) {
        const V s = SinCosRadians(V(std::numbers::pi * x)).sin;
        return s * s;
    } else {
        // Minimax for sin^2(pi x)/x^2 on |x| <= 1/2, 1.4e-8 before rounding; in pairs, for a
        // shorter chain of operations.
        const V y = x * x, ySqr = y * y;
        const V low = T(-32.4696617) * y + T(9.86960411);
        const V middle = T(-30.0985527) * y + T(42.7269287);
        const V high = T(-3.33621097) * y + T(13.0371122);
        return y * ((high * ySqr + middle) * ySqr + low);
    }
}

/// scale sin^2(pi turns), for any finite number of turns.
/// float: 4.1e-5 of `scale`, never below 0, in less time than SinSquaredPi.
template <class V>
class SinSquaredPiApprox {
  public:
    SinSquaredPiApprox() = default;
    explicit SinSquaredPiApprox(const V &scale) : factors{scale} {
        // sin^2(pi x) = 1/2 + sin(2 pi z)/2 with z = |x| - 1/4; the odd polynomial in z is a
        // minimax fit that is exact at |z| = 1/4, so that the least value is 0 but for rounding.
        if constexpr (AnyFloat<V>)
            factors = {scale * T(0.5), scale * T(3.14048577), scale * T(-20.53474913),
                       scale * T(36.5916292)};
    }

    /// References to all that it consists of.
    auto Fields() { return std::tie(factors[0], factors[1], factors[2], factors[3]); }
    auto Fields() const { return std::tie(factors[0], factors[1], factors[2], factors[3]); }

    template <class U>
    [[gnu::always_inline]] U operator()(const U &turns) const {
        if constexpr (AnyFloat<V>) {
            const U z = Abs(turns - Round(turns)) - T(0.25), y = z * z;
            const U slope = (y * factors[3] + factors[2]) * y + factors[1];
            return Max(U(0), z * slope + factors[0]);
        } else {
            return factors[0] * SinSquaredPi(turns);
        }
    }

  private:
    using T = ScalarOf<V>;
    std::array<V, 4> factors;
};

}  // namespace pbrt
