#pragma once

#include <array>
#include <concepts>
#include <numbers>
#include <tuple>

#include "lanes.h"

namespace pbrt::feather {

// Sines of angles in turns. Of floats by polynomials: calls would keep loops from being vectorised.

/// sin^2(pi turns), for any finite number of turns.
/// float: polynomial, 2e-7 relative to the exact value of the rounded argument; written out because
/// a call to sin would keep the loop over the nodes of TRT from being vectorised.
template <class V>
[[gnu::always_inline]] inline V SinSquaredPi(const V &turns) {
    using T = ScalarOf<V>;
    const V x = turns - Rint(turns);
    if constexpr (sizeof(T) > sizeof(float)) {
        const V s = Sin(std::numbers::pi_v<T> * x);
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
/// float: 4e-5 of `scale`, never below 0, in less time than SinSquaredPi: good for TRT.
template <class V>
class RoughSinSquaredPi {
  public:
    RoughSinSquaredPi() = default;
    explicit RoughSinSquaredPi(const V &scale) : factors{scale} {
        // sin^2(pi x) = 1/2 + sin(2 pi z)/2 with z = |x| - 1/4; the odd polynomial in z is a
        // minimax fit that is exact at |z| = 1/4, so that the least value is 0 but for rounding.
        if constexpr (kIsFloat)
            factors = {scale * T(0.5), scale * T(3.14048577), scale * T(-20.53474913),
                       scale * T(36.5916292)};
    }

    /// All that it consists of, see lanes.h.
    auto Fields() { return std::tie(factors[0], factors[1], factors[2], factors[3]); }
    auto Fields() const { return std::tie(factors[0], factors[1], factors[2], factors[3]); }

    template <class U>
    [[gnu::always_inline]] U operator()(const U &turns) const {
        if constexpr (kIsFloat) {
            const U z = Abs(turns - Rint(turns)) - T(0.25), y = z * z;
            const U slope = (y * factors[3] + factors[2]) * y + factors[1];
            return Max(U(0), z * slope + factors[0]);
        } else {
            return factors[0] * SinSquaredPi(turns);
        }
    }

  private:
    using T = ScalarOf<V>;
    static constexpr bool kIsFloat = sizeof(T) == sizeof(float);
    std::array<V, 4> factors;
};

/// Sine and cosine of an angle in turns, of any size.
template <class V>
struct SinCos {
    V sin, cos;
};
/// float: 2e-7.
template <class V>
inline SinCos<V> SinCosTurns(const V &turns) {
    using T = ScalarOf<V>;
    // sin(2 pi z) for |z| <= 1/4; float: minimax, relative error 5e-9 before rounding.
    const auto sine = [](const V &z) {
        if constexpr (sizeof(T) > sizeof(float)) {
            return Sin(2 * std::numbers::pi_v<T> * z);
        } else {
            const V y = z * z;
            const V high = (T(39.7109267) * y - T(76.5749934)) * y + T(81.6022313);
            return z * ((high * y - T(41.3416775)) * y + T(6.28318527));
        }
    };
    const V x = turns - Rint(turns), size = Abs(x);
    return {SignOf(x) * sine(T(0.25) - Abs(size - T(0.25))), sine(T(0.25) - size)};
}

}  // namespace pbrt::feather
