#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include "../simd/math.h"

namespace pbrt::feather {

/// Power shares of the two polarisations.
template <class V>
struct Polarised {
    V s, p;
};

/// e^-x and 1 - e^-x for x >= 0, each to a few roundings of itself.
template <class V>
struct Fade {
    V kept, lost;

    static Fade Of(const V &x) {
        using T = ScalarOf<V>;
        // Above 1/2 the exponential has at least as many digits as its complement; below, it loses
        // none as the complement of the series.
        const V late = ExpOfMinus(x), y = Min(x, V(T(0.5)));
        const V early = y * EvaluateSeries(y);
        const auto small = x < V(T(0.5));
        return {Select(small, 1 - early, late), Select(small, early, 1 - late)};
    }

  private:
    static V ExpOfMinus(const V &x) {
        if constexpr (std::floating_point<V>)
            return std::exp(-x);
        else if constexpr (AnyFloat<V>)
            return Exp(V(-x));
        else
            return MapElements([](auto e) { return std::exp(-e); }, x);
    }
    /// (1 - e^-y) / y for y <= 1/2, by its power series.
    static V EvaluateSeries(const V &y) {
        if constexpr (AnyFloat<V>)  // the first term left out is below 1.1e-8
            return EvaluatePolynomial(y, 1.f, -1.f / 2, 1.f / 6, -1.f / 24, 1.f / 120, -1.f / 720,
                                      1.f / 5040, -1.f / 40320);
        else if constexpr (std::floating_point<V>)
            return y > 0 ? -std::expm1(-y) / y : V(1);
        else
            return MapElements([](auto e) { return e > 0 ? -std::expm1(-e) / e : 1; }, y);
    }
};

/// Reflectance and transmittance of a film, averaged over a thickness with normal distribution
/// (MODEL section 10), at one wavelength and cosine.
///
/// Per polarisation, T = Y / (X + Y) is a Poisson kernel in twice the phase, and the mean damps its
/// n-th harmonic by exp(-n^2 sigma^2 / 2). Two kernels of less contrast, shifted to either side,
/// have the same first and second harmonic. Nothing here is found by subtraction: R and T are in
/// [0, 1] and sum to 1 within rounding. Errors of the mean itself: docs/ACCURACY.md.
template <class V>
class RoughFilmMean {
  public:
    /// sigmaSqr: variance of twice the phase, in rad^2, >= 0; sineSqr: sin^2 of the mean thickness'
    /// phase.
    RoughFilmMean(const V &sigmaSqr, const V &sineSqr) {
        const auto [kept, lost] = Fade<V>::Of(sigmaSqr);
        const V v = Sqrt(1 + lost);
        contrast = Sqrt(kept) * v;
        grey = lost * lost / (1 + contrast);
        const V m = lost / (2 * v * (1 + v));
        sum = 2 * m + 2 * (1 - 2 * m) * sineSqr;
        product = (sineSqr - m) * (sineSqr - m);
    }

    /// Shares of one polarisation, of X = `interference` sin^2 and Y = `passing`^2 that the even
    /// film has; `level` is sqrt(interference + passing^2), >= passing. `limit`: R where both
    /// vanish.
    struct Shares {
        V reflected, transmitted;
    };
    Shares Of(const V &level, const V &passing, const V &interference, const V &limit) const {
        constexpr auto least = std::numeric_limits<ScalarOf<V>>::min();
        const V scale = 1 / Max(level, V(least));
        const V r = passing * scale, q = (interference * scale) * scale;
        const V h = grey + (1 + contrast) * r, g = (1 + contrast) + grey * r;
        const V hSqr = h * h, yq = contrast * q;
        const V both = 16 * yq * product, first = 2 * h * sum;
        const V all = hSqr * hSqr + 4 * yq * hSqr * sum + yq * both;
        // Only for cosines below 1e-9 is this less than the least float: then the shares are within
        // [0, 1] all the same.
        const V perAll = 1 / Max(all, V(least));
        const V R = q * (grey * h * hSqr + contrast * (first * (grey * q + h) + both)) * perAll;
        const V T = r * h * g * (hSqr + 2 * yq * sum) * perAll;
        const auto known = all > 0;
        return {Select(known, R, limit), Select(known, T, 1 - limit)};
    }

  private:
    V contrast;      ///< y of MODEL section 10: of the two kernels, relative to the even film's
    V grey;          ///< z = 1 - y
    V sum, product;  ///< of the sin^2 that the two kernels have
};

}  // namespace pbrt::feather
