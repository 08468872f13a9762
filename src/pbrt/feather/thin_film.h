#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <tuple>

#include "../simd/math.h"
#include "../simd/trig.h"
#include "units.h"

namespace pbrt::feather {

/// Power shares of the two polarisations.
template <class V>
struct Polarised {
    V s, p;
};

/// A film as TRT needs it: what passes it twice, by the squares of the cosines, without a branch.
///
/// With X and Y of MODEL section 3, all times turns^2 / 4: then Y is cosine^2 times the square of
/// the phase, and sin^2 comes with its factor.
template <class V>
class RoundTripTransmittance {
  public:
    RoundTripTransmittance() = default;
    RoundTripTransmittance(const V &turns, const V &excess, const V &invEtaSqr)
        : turnsSqr(turns * turns), invEtaSqr(invEtaSqr) {
        sine = SinSquaredPiApprox<V>(excess * excess * turnsSqr * T(0.25));
        // Films below some 2 nm count as that thick, with their own contrast, lest Y underflows.
        turnsSqr = Max(turnsSqr, V(T(1e-4)));
        turnsSqrExcess = turnsSqr * excess;
    }

    /// All that it consists of, see fields.h.
    auto Fields() {
        return std::tuple_cat(std::tie(turnsSqr, turnsSqrExcess, invEtaSqr), sine.Fields());
    }
    auto Fields() const {
        return std::tuple_cat(std::tie(turnsSqr, turnsSqrExcess, invEtaSqr), sine.Fields());
    }

    /// weight (T_s T_s + T_p T_p) for light that comes in at one angle and leaves at another.
    /// Cosines below 1e-3 count as that: light that passes there counts little. The phase is not
    /// reduced from grazing incidence: 1e-6 of a turn in float.
    template <class U>
    [[gnu::always_inline]] U Weighted(const U &weight, const U &cosineSqrIn,
                                      const U &cosineSqrOut) const {
        const U in = Max(cosineSqrIn, U(T(1e-6))), out = Max(cosineSqrOut, U(T(1e-6)));
        const Terms<U> i = At(in), o = At(out);
        const U both = RcpApprox(i.s * o.s) + RcpApprox(i.p * o.p);
        return weight * (i.y * o.y) * both;
    }

  private:
    using T = ScalarOf<V>;
    template <class U>
    struct Terms {
        U s, p;  ///< X + Y of either polarisation
        U y;
    };
    template <class U>
    [[gnu::always_inline]] Terms<U> At(const U &c2) const {
        const U phaseSqr = turnsSqr * c2 + turnsSqrExcess, y = c2 * phaseSqr;
        const U k = sine(Sqrt(phaseSqr)), brewster = (c2 - 1) * invEtaSqr + c2;
        return {k + y, k * (brewster * brewster) + y, y};
    }

    V turnsSqr, turnsSqrExcess, invEtaSqr;
    SinSquaredPiApprox<V> sine;
};

/// The keratin film at one wavelength: a lossless layer with air on both sides.
///
/// S-eq.1 and S-eq.2 in real numbers (MODEL section 3): reflected and transmitted power are X/(X+Y)
/// and Y/(X+Y), so that they sum to 1 and neither is found by subtraction.
/// Domain: lambda > 0, thickness >= 0, eta >= 1, cosine in [0, 1] measured in air.
template <class V>
struct Film {
    V excess;     ///< eta^2 - 1
    V invEtaSqr;  ///< 1 / eta^2
    V contrast;   ///< (eta^2 - 1)^2
    V turns;      ///< phase in turns per unit of eta cos(angle in the film)
    V grazing;    ///< eta cos(angle in the film) at grazing incidence
    V phase;      ///< phase in turns at grazing incidence, less a whole number
    V fringes;    ///< turns by which the phase changes from normal to grazing incidence
    V limit;      ///< reflectance where X + Y = 0: 0 if there is no film, else 1 (grazing)
    RoundTripTransmittance<V> twice;

    Film() = default;
    Film(const Nm<V> &lambda, const Nm<V> &thickness, const V &eta)
        : excess((eta - 1) * (eta + 1)),
          invEtaSqr(1 / (eta * eta)),
          contrast(excess * excess),
          turns(2 * (thickness / lambda)),
          grazing(Sqrt(excess)),
          phase(PhaseAtGrazing(lambda.value, thickness.value, eta)),
          fringes(turns * (eta - grazing)),
          limit(Select((thickness.value == 0) | (eta == 1), V(0), V(1))),
          twice(turns, excess, invEtaSqr) {}

    /// Unpolarised reflectance, in [0, 1]; one division for both polarisations.
    /// float against double: 5e-7 at worst from 0 to 89.99 deg for films below 2 um.
    V Reflectance(const V &cosine) const {
        const auto [x, y] = Airy(cosine);
        const V s = x.s + y, p = x.p + y;
        // Only for cosines below 1e-9 is the product less than the least float; then this is within
        // [0, 1] all the same.
        constexpr auto least = std::numeric_limits<ScalarOf<V>>::min();
        const V both = (x.s * p + x.p * s) / Max(2 * s * p, V(least));
        return Select(s > 0, both, limit);
    }

    /// Transmittance of each polarisation, in [0, 1].
    Polarised<V> Transmittance(const V &cosine) const {
        const auto [x, y] = Airy(cosine);
        return {Share(y, x.s, 1 - limit), Share(y, x.p, 1 - limit)};
    }

  private:
    struct Terms {
        Polarised<V> x;  ///< X of either polarisation
        V y;             ///< Y, which both share
    };

    // At grazing incidence the fringes are as narrow as the cosine: the phase is reduced from
    // there, once and in double, so that float adds only what the cosine changes.
    static V PhaseAtGrazing(const V &lambda, const V &thickness, const V &eta) {
        const auto n = Convert<double>(eta), d = Convert<double>(thickness);
        const auto whole = 2 * d * Sqrt((n - 1) * (n + 1)) / Convert<double>(lambda);
        return Convert<ScalarOf<V>>(whole - Round(whole));
    }

    Terms Airy(const V &cosine) const {
        using T = ScalarOf<V>;
        const V c2 = cosine * cosine;
        const V insideSqr =
            excess + c2;  // eta^2 cos^2 in the film; eta^2 - s2 without cancellation
        const V sum = Max(grazing + Sqrt(insideSqr), V(std::numeric_limits<T>::min()));
        const V k = contrast * SinSquaredPi(phase + turns * (c2 / sum));
        const V brewster = c2 - (1 - c2) * invEtaSqr;
        return {{k, k * brewster * brewster}, 4 * c2 * insideSqr};
    }

    static V Share(const V &part, const V &rest, const V &limit) {
        const V sum = part + rest;
        return Select(sum > 0, part / sum, limit);
    }
};

/// Films of one index and all thicknesses.
template <class V>
struct AverageFilm {
    V excess, invEtaSqr;  ///< eta^2 - 1, 1 / eta^2

    explicit AverageFilm(const V &eta)
        : excess((eta - 1) * (eta + 1)), invEtaSqr(1 / (eta * eta)) {}

    /// Unpolarised power, reflected : transmitted = 2F/(1+F) : (1-F)/(1+F), with F Fresnel's
    /// reflectance of one surface; both times a factor, so that nothing is divided.
    struct Shares {
        V reflected, transmitted;
    };
    Shares At(const V &cosine) const {
        const V inside = Sqrt(excess + cosine * cosine);  // eta cos(angle in the film)
        const V scaled = inside * invEtaSqr;
        const V s = (cosine - inside) * (cosine + scaled),
                p = (cosine - scaled) * (cosine + inside);
        const V sum = (cosine + inside) * (cosine + scaled);
        const V F = s * s + p * p, whole = 2 * sum * sum;
        return {2 * F, whole - F};
    }
};

}  // namespace pbrt::feather
