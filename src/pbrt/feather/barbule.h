#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>

#include "../simd/simd.h"
#include "../simd/trig.h"
#include "bend.h"
#include "direction.h"
#include "facets.h"
#include "gap.h"
#include "params.h"
#include "pigment_fast.h"
#include "row.h"
#include "thin_film.h"
#include "vane.h"
#include "view.h"

namespace pbrt::feather {

/// The feather's BSDF: glint off the keratin film (R), pigment return (TRT) and gap (T).
///
/// N wavelengths at once. V: a scalar, or SimdX16 for the feathers at sixteen vertices side by
/// side, each as it would be alone but for rounding; floats' TRT, to 1e-3 of its value at worst.
/// Directions are of Direction's local frame, on either side of the vane. R, TRT and f are in 1/sr
/// without a cosine, >= 0, finite, symmetric in wo and wi, and 0 where |wo.z| or |wi.z| is Grazing.
/// Nothing here is random but what the caller's numbers make so. `Quadrature` integrates TRT, see
/// pigment_fast.h. Source: MODEL sections 3 to 7.
template <class V, int N, class Quadrature = AdaptiveRule>
class Barbule {
    using T = ScalarOf<V>;
    using Mask = MaskFor<V>;
    /// Type in which a view's direction is taken: scalars by value, for a reference would keep all
    /// of the view in memory; vectors by reference, as everywhere (simd/registers.h).
    using Kept = std::conditional_t<std::floating_point<V>, Direction<V>, const Direction<V> &>;

  public:
    using Spectrum = std::array<V, N>;

    /// `params` within kParams' ranges, `optics` within kSpectrumParams'.
    Barbule(const BarbuleParams<T> &params,
            const Optics<V, N> &optics) requires std::floating_point<V>
        : Barbule(Vane<V>(params), params.thickness, optics, params.filmRoughness) {}
    /// `roughness`: standard deviation of the film's thickness.
    Barbule(const Vane<V> &vane, const Nm<V> &thickness, const Optics<V, N> &optics,
            const Nm<V> &roughness = {V(0)})
        : row(vane.row),
          bend(vane.bend),
          melanin(optics.melanin),
          meanMelanin(Mean(optics.melanin)),
          averageFilm(Mean(optics.eta)) {
        for (int i = 0; i < N; ++i)
            films[i] = Film<V>(Nm<V>{optics.lambda[i]}, thickness, optics.eta[i], roughness);
    }

    View<V> SeenFrom(const Direction<V> &wo) const {
        return {wo, MeanNormal(wo), PigmentChance(Abs(wo.z)), Grazing(wo)};
    }

    /// Reflection off the film, with interference.
    Spectrum R(const View<V> &view, const Direction<V> &wi) const {
        const Kept wo = view.wo;
        Spectrum sum;
        sum.fill(V(0));
        AddReflected(wo, wi, &sum);
        return sum;
    }

    /// In through the film, off the melanin, out through the film.
    Spectrum TRT(const View<V> &view, const Direction<V> &wi) const {
        const Kept wo = view.wo;
        Spectrum sum;
        SetReturned(wo, wi, &sum);
        return sum;
    }

    /// R + TRT; the gap is a delta and not in f.
    Spectrum f(const View<V> &view, const Direction<V> &wi) const { return f(view.wo, wi); }
    /// The same, where nothing else is asked of the view.
    Spectrum f(Kept wo, const Direction<V> &wi) const {
        Spectrum sum;
        SetReturned(wo, wi, &sum);
        AddReflected(wo, wi, &sum);
        return sum;
    }

    /// Density with which SampleDirection draws wi, 1/sr, the gap's delta apart; its integral is
    /// 1 - (1 - p_t) GapFraction(wo). Exact for every opening.
    V PDF(const View<V> &view, const Direction<V> &wi) const {
        const Mask dark = view.grazing | Grazing(wi);
        if (All(dark)) return V(0);
        const V reflected = MirrorDensity(view.wo, wi);
        return Select(dark, V(0),
                      Finite(view.pigmentChance * PigmentLobe(view, wi) +
                             (1 - view.pigmentChance) * reflected));
    }

    /// A direction drawn for uc, u0, u1 in [0, 1), without its density; where `isGap`, it is -wo
    /// with the probability 1 - p_t. Anything where wo is Grazing.
    struct Drawn {
        Direction<V> wi;
        Mask isGap;
    };
    Drawn Draw(const View<V> &view, const V &uc, const V &u0, const V &u1) const {
        const Mask pigment = uc < view.pigmentChance;
        Direction<V> wi{};
        if (Any(pigment)) wi = SamplePigment(view, uc / view.pigmentChance, u0, u1);
        if (All(pigment)) return {wi, !pigment};
        const V rest = Min((uc - view.pigmentChance) / (1 - view.pigmentChance), V(kBelowOne));
        const Segment<V> segment = bend.Sample(view.wo, u0);
        const RowView<V> seen = row.SeenFrom(segment.Across(view.wo));
        const Mask isGap = (rest < seen.Gap()) & !pigment;
        if (All(isGap)) return {-view.wo, isGap};
        const Planar<V> e = seen.PointAt(seen.lower + (seen.upper - seen.lower) * u1);
        const Direction<V> m = NormalAt(row, segment, e);
        const V twice = 2 * Dot(m, view.wo);
        const Direction<V> mirrored{twice * m.x - view.wo.x, twice * m.y - view.wo.y,
                                    twice * m.z - view.wo.z};
        return {Select(isGap, -view.wo, Select(pigment, wi, mirrored)), isGap};
    }

    /// Draws wi without evaluating f, which is left 0 except for a gap. uc, u0, u1 in [0, 1).
    std::optional<Sample<T, N>> SampleDirection(const View<V> &view, V uc, V u0,
                                                V u1) const requires std::floating_point<V> {
        if (view.grazing) return {};
        const Drawn drawn = Draw(view, uc, u0, u1);
        if (drawn.isGap) return GapSample(view);
        Sample<T, N> sample{drawn.wi, {}, PDF(view, drawn.wi), false};
        if (sample.pdf == 0) return {};
        return sample;
    }

    /// Draws wi, and evaluates f there.
    std::optional<Sample<T, N>> Sample_f(const View<V> &view, V uc, V u0,
                                         V u1) const requires std::floating_point<V> {
        auto sample = SampleDirection(view, uc, u0, u1);
        if (sample && !sample->isGap) sample->f = f(view, sample->wi);
        return sample;
    }

    /// Share of light from w that passes straight through, T(w) = T(-w), in [0, 1].
    V GapFraction(const Direction<V> &w) const { return feather::GapFraction(row, bend, w); }

  private:
    static constexpr T kBelowOne = 1 - std::numeric_limits<T>::epsilon() / 2;

    /// The mean of the wavelengths' values.
    static V Mean(const Spectrum &values) {
        V sum = values[0];
        for (int i = 1; i < N; ++i)
            sum = sum + values[i];
        return sum * (T(1) / N);
    }
    static V Finite(const V &x) { return Min(x, V(std::numeric_limits<T>::max())); }
    static Mask SameSide(const Direction<V> &a, const Direction<V> &b) {
        return SignOf(a.z) == SignOf(b.z);
    }

    // What is not inlined is compiled once: copies may round differently, and near the edge of what
    // is seen the last bit decides between 0 and all.

    [[gnu::noinline]] void AddReflected(const Direction<V> &wo, const Direction<V> &wi,
                                        Spectrum *sum) const {
        const Direction<V> m = Between(wo, wi);
        Mask lit = bend.MayHaveNormal(m) & !(Grazing(wo) | Grazing(wi));
        if (!Any(lit)) return;
        const V length = Sqrt(Dot(m, m));
        const Facet<V> facet = FacetTowards(m, length);
        lit = lit & Sees(row, bend, wo, facet);
        if (!Any(lit)) return;
        lit = lit & Sees(row, bend, wi, facet);
        if (!Any(lit)) return;
        const V scale = FacetDensity(row, bend, facet) / (4 * Abs(wo.z) * Abs(wi.z));
        const V cosine = Min(length * T(0.5), V(1));
        if (AnyRough(films))
            AddReflectances<true>(lit, cosine, scale, sum);
        else
            AddReflectances<false>(lit, cosine, scale, sum);
    }

    template <bool kRough>
    void AddReflectances(const Mask &lit, const V &cosine, const V &scale, Spectrum *sum) const {
        for (int i = 0; i < N; ++i) {
            const V R = Finite(films[i].template ReflectanceIf<kRough>(cosine) * scale);
            (*sum)[i] = Select(lit, (*sum)[i] + R, (*sum)[i]);
        }
    }

    [[gnu::noinline]] void SetReturned(const Direction<V> &wo, const Direction<V> &wi,
                                       Spectrum *f) const {
        const Mask dark = Grazing(wo) | Grazing(wi) | (row.Closed() & !SameSide(wo, wi));
        if (All(dark)) {
            f->fill(V(0));
            return;
        }
        const V scale = 1 / (std::numbers::pi_v<T> * Abs(wo.z) * Abs(wi.z));
        Spectrum integral;
        if constexpr (std::floating_point<V>)
            Quadrature::Integrate(row, bend, films, wo, wi, &integral);
        else
            Quadrature::Integrate(row, bend, films, wo, wi, dark, &integral);
        for (int i = 0; i < N; ++i)
            (*f)[i] = Select(dark, V(0), Finite(melanin[i] * scale * integral[i]));
    }

    /// Density of wi among the mirror directions of the facets that wo sees, 1/sr.
    [[gnu::noinline]] V MirrorDensity(const Direction<V> &wo, const Direction<V> &wi) const {
        const Direction<V> m = Between(wo, wi);
        Mask seen = bend.MayHaveNormal(m);
        if (!Any(seen)) return V(0);
        const Facet<V> facet = FacetTowards(m, Sqrt(Dot(m, m)));
        seen = seen & Sees(row, bend, wo, facet);
        if (!Any(seen)) return V(0);
        return Select(seen, FacetDensity(row, bend, facet) / (4 * Abs(wo.z)), V(0));
    }

    /// Along the normal that mirrors wo into wi.
    static Direction<V> Between(const Direction<V> &wo, const Direction<V> &wi) {
        return {wo.x + wi.x, wo.y + wi.y, wo.z + wi.z};
    }
    /// The facet with the normal m = Between(wo, wi); at the pole, where nothing is seen, if the
    /// two are opposite and their sum has no direction that could be trusted.
    Facet<V> FacetTowards(const Direction<V> &m, const V &length) const {
        const Mask opposite = length < V(16 * std::numeric_limits<T>::epsilon());
        return FacetWithNormal(row, m, Select(opposite, V(std::numeric_limits<T>::max()), length));
    }

    /// p_t: the share of TRT in what a flat film of random thickness would return, by the
    /// wavelengths' mean index and melanin. Beyond 70 degrees the facets that are seen face wo
    /// better than the vane does (at 85 degrees TRT returns 2 to 15 % of the light, the flat film
    /// 0.5 %), so that cosine is the least.
    V PigmentChance(const V &cosine) const {
        const auto [rho, through] = averageFilm.At(Min(Max(cosine, V(T(0.35))), V(1)));
        // Both times the square of rho + through.
        const V tau = meanMelanin * through * through, reflected = rho * (rho + through);
        return Select(tau > 0, tau / (tau + reflected), V(0));
    }

    /// The lobes for TRT are cosines about the vane's normal on wo's side, about the mean visible
    /// normal, and about the other side's normal: together they miss nothing that f_TRT reaches.
    /// Chances 50/45/5 %; a closed row lets nothing through and has the first two only.
    static constexpr T kVaneLobe = T(0.5);
    V ThroughLobe() const { return Select(row.Closed(), V(0), V(T(0.05))); }

    V PigmentLobe(const View<V> &view, const Direction<V> &wi) const {
        const V above = SignOf(view.wo.z) * wi.z, through = ThroughLobe();
        const V vane = Select(above > 0, kVaneLobe * above, -through * above);
        const V mean = Max(V(0), Dot(view.meanNormal, wi));
        return (vane + (1 - kVaneLobe - through) * mean) * std::numbers::inv_pi_v<T>;
    }

    Direction<V> SamplePigment(const View<V> &view, const V &uc, const V &u0, const V &u1) const {
        const V side = SignOf(view.wo.z);
        const Direction<V> axis = Select(
            uc < V(kVaneLobe), Direction<V>{V(0), V(0), side},
            Select(uc < 1 - ThroughLobe(), view.meanNormal, Direction<V>{V(0), V(0), -side}));
        // A point of the unit sphere about the axis' tip lies in a cosine-distributed direction.
        const V z = 1 - 2 * u0, radius = Sqrt(Max(V(0), 1 - z * z));
        const auto [sine, cosine] = SinCosTurns(u1);
        return Normalized({axis.x + radius * cosine, axis.y + radius * sine, axis.z + z}, axis);
    }

    /// The normal half-way across what wo sees of the segment that halves its view of the arc.
    Direction<V> MeanNormal(const Direction<V> &wo) const {
        const Direction<V> vane{V(0), V(0), SignOf(wo.z)};
        const Mask grazing = Grazing(wo);
        if (All(grazing)) return vane;
        const auto [middle, rSqr, along] = bend.MiddleSeenFrom(wo);
        // Of any length: nothing is divided.
        const auto [e, reachSqr] = row.MiddleSeenFrom(Planar<V>{along, wo.x});
        const Planar<V> n = row.FromAxes({e.n, row.Aspect() * e.x});
        return Select(
            grazing, vane,
            Normalized({n.x * rSqr, n.n * middle.x, n.n * middle.n}, vane, reachSqr * rSqr));
    }

    /// w with length 1; `otherwise` if it is shorter than rounding leaves vectors of length `unit`.
    static Direction<V> Normalized(const Direction<V> &w, const Direction<V> &otherwise,
                                   const V &unit = V(1)) {
        const V lengthSqr = Dot(w, w), least = std::numeric_limits<T>::epsilon() * unit;
        const Mask known = lengthSqr > least * least;
        if (!Any(known)) return otherwise;
        const V scale = 1 / Sqrt(lengthSqr);
        return Select(known, Direction<V>{w.x * scale, w.y * scale, w.z * scale}, otherwise);
    }

    Sample<T, N> GapSample(const View<V> &view) const requires std::floating_point<V> {
        Sample<T, N> sample{-view.wo, {}, 1 - view.pigmentChance, true};
        sample.f.fill(1 / std::abs(view.wo.z));
        return sample;
    }

    Row<V> row;
    Bend<V> bend;
    std::array<Film<V>, N> films;
    Spectrum melanin;
    V meanMelanin;
    AverageFilm<V> averageFilm;  ///< of the mean index
};

}  // namespace pbrt::feather
