#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <tuple>

#include "../simd/math.h"
#include "../simd/trig.h"
#include "rough_film.h"
#include "units.h"

namespace pbrt::feather {

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
        return Weigh(
            weight, cosineSqrIn,
            cosineSqrOut, [&](const U &phaseSqr) __attribute__((always_inline)) {
                return sine(Sqrt(phaseSqr));
            });
    }

  protected:
    using T = ScalarOf<V>;
    /// Weighted, with sin^2, times its factor, of the square of the phase.
    template <class U, class SineSqr>
    [[gnu::always_inline]] U Weigh(const U &weight, const U &cosineSqrIn, const U &cosineSqrOut,
                                   const SineSqr &sineSqr) const {
        const U in = Max(cosineSqrIn, U(T(1e-6))), out = Max(cosineSqrOut, U(T(1e-6)));
        const Terms<U> i = At(in, sineSqr), o = At(out, sineSqr);
        const U both = RcpApprox(i.s * o.s) + RcpApprox(i.p * o.p);
        return weight * (i.y * o.y) * both;
    }

  private:
    template <class U>
    struct Terms {
        U s, p;  ///< X + Y of either polarisation
        U y;
    };
    template <class U, class SineSqr>
    [[gnu::always_inline]] Terms<U> At(const U &c2, const SineSqr &sineSqr) const {
        const U phaseSqr = turnsSqr * c2 + turnsSqrExcess, y = c2 * phaseSqr;
        const U k = sineSqr(phaseSqr), brewster = (c2 - 1) * invEtaSqr + c2;
        return {k + y, k * (brewster * brewster) + y, y};
    }

  protected:
    V turnsSqr, turnsSqrExcess, invEtaSqr;
    SinSquaredPiApprox<V> sine;
};

/// The same for a film of varying thickness: sin^2 is replaced by its mean, 1/2 + D (sin^2 - 1/2)
/// with D = exp(-sigma^2 / 2) (MODEL section 10). T is a convex function of sin^2, so that this is
/// never above T's mean; in TRT it is 0.6, 1.9 and 3.4 % below for deviations of 10, 20 and 40 nm.
template <class V>
class RoughRoundTripTransmittance : public RoundTripTransmittance<V> {
    using Even = RoundTripTransmittance<V>;
    using T = ScalarOf<V>;

  public:
    RoughRoundTripTransmittance() = default;
    /// `roughTurns` stand to `turns` as the thickness' standard deviation to its mean.
    RoughRoundTripTransmittance(const V &turns, const V &roughTurns, const V &excess,
                                const V &invEtaSqr)
        : Even(turns, excess, invEtaSqr), half(0), damping(0) {
        const V roughSqr = roughTurns * roughTurns;
        if (!Any(roughSqr > 0)) return;
        // A film that counts as thicker than it is has its mean square, if that reaches so far.
        const V raised = Max(V(0), this->turnsSqr - turns * turns);
        const V square = turns * turns + Min(roughSqr, raised);
        this->sine = SinSquaredPiApprox<V>(excess * excess * square * T(0.25));
        half = excess * excess * square * T(0.125);
        damping = T(2 * std::numbers::pi * std::numbers::pi) * Max(V(0), roughSqr - raised) /
                  this->turnsSqr;
    }

    auto Fields() { return std::tuple_cat(Even::Fields(), std::tie(half, damping)); }
    auto Fields() const { return std::tuple_cat(Even::Fields(), std::tie(half, damping)); }

    /// As RoundTripTransmittance's.
    template <class U>
    [[gnu::always_inline]] U Weighted(const U &weight, const U &cosineSqrIn,
                                      const U &cosineSqrOut) const {
        return Even::Weigh(
            weight, cosineSqrIn,
            cosineSqrOut, [&](const U &phaseSqr) __attribute__((always_inline)) {
                return half + Kept(phaseSqr) * (this->sine(Sqrt(phaseSqr)) - half);
            });
    }

  private:
    /// D, by a power of a series: R + T <= 1 + 1.3e-5 with RoughFilmMean's R.
    template <class U>
    [[gnu::always_inline]] U Kept(const U &phaseSqr) const {
        const U t = Min(phaseSqr * damping, U(T(8))) * T(0.125);
        const U root = (t * T(0.5) - 1) * t + 1, square = root * root, fourth = square * square;
        return fourth * fourth;
    }

    V half;     ///< of the scale of the sine
    V damping;  ///< sigma^2 / 2 over the square of the phase in turns
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
    V roughness;  ///< variance of twice the phase per square of eta cos(angle in the film), rad^2
    RoughRoundTripTransmittance<V> twice;

    Film() = default;
    /// `deviation`: the standard deviation of the thickness.
    Film(const Nm<V> &lambda, const Nm<V> &thickness, const V &eta, const Nm<V> &deviation = {V(0)})
        : excess((eta - 1) * (eta + 1)),
          invEtaSqr(1 / (eta * eta)),
          contrast(excess * excess),
          turns(2 * (thickness / lambda)),
          grazing(Sqrt(excess)),
          phase(PhaseAtGrazing(lambda.value, thickness.value, eta)),
          fringes(turns * (eta - grazing)),
          limit(Select(((thickness.value == 0) & (deviation.value == 0)) | (eta == 1), V(0), V(1))),
          roughness(Square(T(4 * std::numbers::pi) * (deviation / lambda))),
          twice(turns, 2 * (deviation / lambda), excess, invEtaSqr) {}

    /// True where the thickness varies.
    MaskFor<V> IsRough() const { return roughness > 0; }

    /// Unpolarised reflectance, in [0, 1].
    V Reflectance(const V &cosine) const {
        return Any(IsRough()) ? ReflectanceIf<true>(cosine) : ReflectanceIf<false>(cosine);
    }
    /// The same where it is known whether any of the films is rough; one division for both
    /// polarisations, two more if so. float against double: of even films up to 2 um 5e-7 at worst
    /// from 0 to 89.99 deg.
    template <bool kRough>
    V ReflectanceIf(const V &cosine) const {
        const V even = EvenReflectance(cosine);
        if constexpr (!kRough) return even;
        const auto [s, p] = Mean(cosine);
        return Select(IsRough(), (s.reflected + p.reflected) * T(0.5), even);
    }

    /// Transmittance of each polarisation, in [0, 1].
    Polarised<V> Transmittance(const V &cosine) const {
        const auto [x, y] = Airy(cosine);
        const Polarised<V> even{Share(y, x.s, 1 - limit), Share(y, x.p, 1 - limit)};
        if (!Any(IsRough())) return even;
        const auto [s, p] = Mean(cosine);
        return {Select(IsRough(), s.transmitted, even.s), Select(IsRough(), p.transmitted, even.p)};
    }

  private:
    using T = ScalarOf<V>;
    struct Terms {
        Polarised<V> x;  ///< X of either polarisation
        V y;             ///< Y, which both share
    };

    static V Square(const V &x) { return x * x; }

    V EvenReflectance(const V &cosine) const {
        const auto [x, y] = Airy(cosine);
        const V s = x.s + y, p = x.p + y;
        // Only for cosines below 1e-9 is the product less than the least float; then this is within
        // [0, 1] all the same.
        constexpr auto least = std::numeric_limits<ScalarOf<V>>::min();
        const V both = (x.s * p + x.p * s) / Max(2 * s * p, V(least));
        return Select(s > 0, both, limit);
    }

    /// The mean over the thickness.
    Polarised<typename RoughFilmMean<V>::Shares> Mean(const V &cosine) const {
        const V c2 = cosine * cosine, insideSqr = excess + c2, inside = Sqrt(insideSqr);
        const RoughFilmMean<V> mean(roughness * insideSqr, SineSquared(c2, inside));
        const V passing = 2 * cosine * inside, brewster = c2 - (1 - c2) * invEtaSqr;
        return {mean.Of(insideSqr + c2, passing, contrast, limit),
                mean.Of(insideSqr * invEtaSqr + (excess + 1) * c2, passing,
                        contrast * brewster * brewster, limit)};
    }

    // At grazing incidence the fringes are as narrow as the cosine: the phase is reduced from
    // there, once and in double, so that float adds only what the cosine changes.
    static V PhaseAtGrazing(const V &lambda, const V &thickness, const V &eta) {
        const auto n = Convert<double>(eta), d = Convert<double>(thickness);
        const auto whole = 2 * d * Sqrt((n - 1) * (n + 1)) / Convert<double>(lambda);
        return Convert<ScalarOf<V>>(whole - Round(whole));
    }

    /// sin^2 of the phase for `inside`, eta cos(angle in the film).
    V SineSquared(const V &c2, const V &inside) const {
        const V sum = Max(grazing + inside, V(std::numeric_limits<T>::min()));
        return SinSquaredPi(phase + turns * (c2 / sum));
    }

    Terms Airy(const V &cosine) const {
        const V c2 = cosine * cosine;
        const V insideSqr =
            excess + c2;  // eta^2 cos^2 in the film; eta^2 - s2 without cancellation
        const V k = contrast * SineSquared(c2, Sqrt(insideSqr));
        const V brewster = c2 - (1 - c2) * invEtaSqr;
        return {{k, k * brewster * brewster}, 4 * c2 * insideSqr};
    }

    static V Share(const V &part, const V &rest, const V &limit) {
        const V sum = part + rest;
        return Select(sum > 0, part / sum, limit);
    }
};

/// Films of the wavelengths of one feather, or of sixteen: whether the thickness of any varies.
template <class V, std::size_t N>
bool AnyRough(const std::array<Film<V>, N> &films) {
    return Any(films[0].IsRough());
}

/// The share that passes the film twice; of a film known to be even, for less.
template <bool kRough, class V>
[[gnu::always_inline]] inline const auto &TwiceOf(const Film<V> &film) {
    if constexpr (kRough)
        return film.twice;
    else
        return static_cast<const RoundTripTransmittance<V> &>(film.twice);
}

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
