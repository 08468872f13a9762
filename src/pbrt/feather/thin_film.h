#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "pack.h"
#include "units.h"

namespace pbrt::feather {

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

/// Power shares of the two polarisations.
template <class V>
struct Polarised {
    V s, p;
};

/// The keratin film at one wavelength: a lossless layer with air on both sides.
///
/// S-eq.1 and S-eq.2 in real numbers (MODEL section 3): reflected and transmitted power are X/(X+Y)
/// and Y/(X+Y), so that they sum to 1 and neither is found by subtraction.
/// Domain: lambda > 0, thickness >= 0, eta >= 1, cosine in [0, 1] measured in air.
template <std::floating_point T>
struct Film {
    T excess;                 ///< eta^2 - 1
    T invEtaSqr;              ///< 1 / eta^2
    T contrast;               ///< (eta^2 - 1)^2
    T turns;                  ///< phase in turns per unit of eta cos(angle in the film)
    T grazing;                ///< eta cos(angle in the film) at grazing incidence
    T phase;                  ///< phase in turns at grazing incidence, less a whole number
    T fringes;                ///< turns by which the phase changes from normal to grazing incidence
    T scale, scaledContrast;  ///< 4 and contrast, scaled for ThroughTwice
    T limit;  ///< reflectance where X + Y = 0: 0 if there is no film, else 1 (grazing)

    Film() = default;
    Film(Nm<T> lambda, Nm<T> thickness, T eta)
        : excess((eta - 1) * (eta + 1)),
          invEtaSqr(1 / (eta * eta)),
          contrast(excess * excess),
          turns(2 * (thickness / lambda)),
          grazing(std::sqrt(excess)),
          phase(PhaseAtGrazing(lambda, thickness, eta)),
          fringes(turns * (eta - grazing)),
          scale(T(1 << 22) * invEtaSqr * invEtaSqr),
          scaledContrast(contrast * scale / 4),
          limit(thickness.value == 0 || eta == 1 ? T(0) : T(1)) {}

    /// Unpolarised reflectance, in [0, 1]; one division for both polarisations.
    /// float against double: 5e-7 at worst from 0 to 89.99 deg for films below 2 um.
    T Reflectance(T cosine) const {
        const auto [x, y] = Airy(cosine);
        const T s = x.s + y, p = x.p + y;
        // Only for cosines below 1e-9 is the product less than the least float; then this is within
        // [0, 1] all the same.
        const T both = (x.s * p + x.p * s) / std::max(2 * s * p, std::numeric_limits<T>::min());
        return s > 0 ? both : limit;
    }

    /// Transmittance of each polarisation, in [0, 1].
    Polarised<T> Transmittance(T cosine) const {
        const auto [x, y] = Airy(cosine);
        return {Share(y, x.s, 1 - limit), Share(y, x.p, 1 - limit)};
    }

    /// (T_s T_s + T_p T_p)/2 for light that comes in at one angle and leaves at another, by the
    /// squares of their cosines. One division, no branch; the phase is not reduced from grazing
    /// incidence, where light that passes counts little: 1e-6 of a turn in float.
    template <class V>
    [[gnu::always_inline]] V ThroughTwice(const V &cosineSqrIn, const V &cosineSqrOut) const {
        const Terms<V> i = AiryInline(cosineSqrIn), o = AiryInline(cosineSqrOut);
        const V s = (i.y + i.x.s) * (o.y + o.x.s), p = (i.y + i.x.p) * (o.y + o.x.p);
        return T(0.5) * i.y * o.y * (s + p) / (s * p);
    }

  private:
    template <class V>
    struct Terms {
        Polarised<V> x;  ///< X of either polarisation
        V y;             ///< Y, which both share
    };

    // At grazing incidence the fringes are as narrow as the cosine: the phase is reduced from
    // there, once and in double, so that float adds only what the cosine changes.
    static T PhaseAtGrazing(Nm<T> lambda, Nm<T> thickness, T eta) {
        const double n = eta, d = thickness.value;
        const double whole = 2 * d * std::sqrt((n - 1) * (n + 1)) / lambda.value;
        return T(whole - std::rint(whole));
    }

    Terms<T> Airy(T cosine) const {
        const T c2 = cosine * cosine;
        const T insideSqr =
            excess + c2;  // eta^2 cos^2 in the film; eta^2 - s2 without cancellation
        const T sum = std::max(grazing + std::sqrt(insideSqr), std::numeric_limits<T>::min());
        const T k = contrast * SinSquaredPi(phase + turns * (c2 / sum));
        const T brewster = c2 - (1 - c2) * invEtaSqr;
        return {{k, k * brewster * brewster}, 4 * c2 * insideSqr};
    }

    // Scaled so that a product of four terms neither overflows nor, from a cosine of 1e-4 (below it
    // counts as that), underflows in float.
    template <class V>
    [[gnu::always_inline]] Terms<V> AiryInline(const V &cosineSqr) const {
        const V c2 = Max(cosineSqr, V(T(1e-8))), insideSqr = excess + c2;
        const V k = scaledContrast * SinSquaredPi(turns * Sqrt(insideSqr));
        const V brewster = c2 + c2 * invEtaSqr - invEtaSqr;
        return {{k, k * brewster * brewster}, scale * c2 * insideSqr};
    }

    static T Share(T part, T rest, T limit) {
        const T sum = part + rest;
        return sum > 0 ? part / sum : limit;
    }
};

/// Films of one index and all thicknesses.
template <std::floating_point T>
struct AverageFilm {
    T excess, invEtaSqr;  ///< eta^2 - 1, 1 / eta^2

    explicit AverageFilm(T eta) : excess((eta - 1) * (eta + 1)), invEtaSqr(1 / (eta * eta)) {}

    /// Unpolarised power, reflected : transmitted = 2F/(1+F) : (1-F)/(1+F), with F Fresnel's
    /// reflectance of one surface; both times a factor, so that nothing is divided.
    struct Shares {
        T reflected, transmitted;
    };
    Shares At(T cosine) const {
        const T inside = std::sqrt(excess + cosine * cosine);  // eta cos(angle in the film)
        const T scaled = inside * invEtaSqr;
        const T s = (cosine - inside) * (cosine + scaled),
                p = (cosine - scaled) * (cosine + inside);
        const T sum = (cosine + inside) * (cosine + scaled);
        const T F = s * s + p * p, whole = 2 * sum * sum;
        return {2 * F, whole - F};
    }
};

}  // namespace pbrt::feather
