#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>

#include "bend.h"
#include "direction.h"
#include "facets.h"
#include "gap.h"
#include "pack.h"
#include "params.h"
#include "pigment_fast.h"
#include "row.h"
#include "thin_film.h"
#include "vane.h"

namespace pbrt::feather {

/// What scatters light at a vertex, seen from one direction; made by Barbule::SeenFrom.
/// Sampler, pdf and f read it, so that they cannot drift apart.
template <std::floating_point T>
struct View {
    Direction<T> wo;
    Direction<T> meanNormal;  ///< of the facets that wo sees, about
    T pigmentChance;          ///< probability of the TRT lobes, p_t
    bool grazing;             ///< see Grazing: nothing is scattered
};

/// A drawn direction. `pdf` is of all lobes, 1/sr; for a gap it is the probability of the delta
/// lobe wi = -wo, and f its weight / |wi.z|.
template <std::floating_point T, int N>
struct Sample {
    Direction<T> wi;
    std::array<T, N> f;
    T pdf;
    bool isGap;
};

/// The feather's BSDF: glint off the keratin film (R), pigment return (TRT) and gap (T).
///
/// N wavelengths at once. Directions are of Direction's local frame, on either side of the vane.
/// R, TRT and f are in 1/sr without a cosine, >= 0, finite, symmetric in wo and wi, and 0 where
/// |wo.z| or |wi.z| is Grazing. Nothing here is random but what the caller's numbers make
/// so. `Quadrature` integrates TRT, see pigment_fast.h. Source: MODEL sections 3 to 7.
template <std::floating_point T, int N, class Quadrature = AdaptiveRule>
class Barbule {
  public:
    using Spectrum = std::array<T, N>;

    /// `params` within kParams' ranges, `optics` within kSpectrumParams'.
    Barbule(const BarbuleParams<T> &params, const Optics<T, N> &optics)
        : Barbule(Vane<T>(params), params.thickness, optics) {}
    Barbule(const Vane<T> &vane, Nm<T> thickness, const Optics<T, N> &optics)
        : row(vane.row),
          bend(vane.bend),
          melanin(optics.melanin),
          meanMelanin(Sum(optics.melanin) / N),
          averageFilm(Sum(optics.eta) / N) {
        for (int i = 0; i < N; ++i)
            films[i] = Film<T>(Nm<T>{optics.lambda[i]}, thickness, optics.eta[i]);
    }

    View<T> SeenFrom(Direction<T> wo) const {
        return {wo, MeanNormal(wo), PigmentChance(std::abs(wo.z)), Grazing(wo)};
    }

    /// Reflection off the film, with interference.
    Spectrum R(const View<T> &view, const Direction<T> &wi) const {
        const Direction<T> wo = view.wo;  // a reference to it would keep all of the view alive
        Spectrum sum{};
        AddReflected(wo, wi, &sum);
        return sum;
    }

    /// In through the film, off the melanin, out through the film.
    Spectrum TRT(const View<T> &view, const Direction<T> &wi) const {
        const Direction<T> wo = view.wo;
        Spectrum sum;
        SetReturned(wo, wi, &sum);
        return sum;
    }

    /// R + TRT; the gap is a delta and not in f.
    Spectrum f(const View<T> &view, const Direction<T> &wi) const {
        const Direction<T> wo = view.wo;
        Spectrum sum;
        SetReturned(wo, wi, &sum);
        AddReflected(wo, wi, &sum);
        return sum;
    }

    /// Density with which SampleDirection draws wi, 1/sr, the gap's delta apart; its integral is
    /// 1 - (1 - p_t) GapFraction(wo). Exact for every opening.
    T Pdf(const View<T> &view, Direction<T> wi) const {
        if (view.grazing || Grazing(wi)) return 0;
        const T reflected = MirrorDensity(view.wo, wi);
        return Finite(view.pigmentChance * PigmentLobe(view, wi) +
                      (1 - view.pigmentChance) * reflected);
    }

    /// Draws wi without evaluating f, which is left 0 except for a gap. uc, u0, u1 in [0, 1).
    std::optional<Sample<T, N>> SampleDirection(const View<T> &view, T uc, T u0, T u1) const {
        if (view.grazing) return {};
        Sample<T, N> sample{};
        if (uc < view.pigmentChance) {
            sample.wi = SamplePigment(view, uc / view.pigmentChance, u0, u1);
        } else {
            uc = std::min((uc - view.pigmentChance) / (1 - view.pigmentChance), kBelowOne);
            const Segment<T> segment = bend.Sample(view.wo, u0);
            const RowView<T> seen = row.SeenFrom(segment.Across(view.wo));
            if (uc < seen.Gap()) return GapSample(view);
            const Planar<T> e = seen.PointAt(seen.lower + (seen.upper - seen.lower) * u1);
            const Direction<T> m = NormalAt(row, segment, e);
            const T twice = 2 * Dot(m, view.wo);
            sample.wi = {twice * m.x - view.wo.x, twice * m.y - view.wo.y, twice * m.z - view.wo.z};
        }
        sample.pdf = Pdf(view, sample.wi);
        if (sample.pdf == 0) return {};
        return sample;
    }

    /// Draws wi, and evaluates f there.
    std::optional<Sample<T, N>> Sample_f(const View<T> &view, T uc, T u0, T u1) const {
        auto sample = SampleDirection(view, uc, u0, u1);
        if (sample && !sample->isGap) sample->f = f(view, sample->wi);
        return sample;
    }

    /// Share of light from w that passes straight through, T(w) = T(-w), in [0, 1].
    T GapFraction(Direction<T> w) const { return feather::GapFraction(row, bend, w); }

  private:
    static constexpr T kBelowOne = 1 - std::numeric_limits<T>::epsilon() / 2;

    static T Finite(T x) { return std::min(x, std::numeric_limits<T>::max()); }
    static bool SameSide(const Direction<T> &a, const Direction<T> &b) {
        return (a.z < 0) == (b.z < 0);
    }

    // What is not inlined is compiled once: copies may round differently, and near the edge of what
    // is seen the last bit decides between 0 and all.

    [[gnu::noinline]] void AddReflected(const Direction<T> &wo, const Direction<T> &wi,
                                        Spectrum *sum) const {
        if (Grazing(wo) || Grazing(wi)) return;
        const Direction<T> m = Between(wo, wi);
        if (!bend.MayHaveNormal(m)) return;
        const T length = std::sqrt(Dot(m, m));
        const Facet<T> facet = FacetTowards(m, length);
        if (!Sees(row, bend, wo, facet) || !Sees(row, bend, wi, facet)) return;
        const T scale = FacetDensity(row, bend, facet) / (4 * std::abs(wo.z) * std::abs(wi.z));
        for (int i = 0; i < N; ++i)
            (*sum)[i] += Finite(films[i].Reflectance(std::min(length / 2, T(1))) * scale);
    }

    [[gnu::noinline]] void SetReturned(const Direction<T> &wo, const Direction<T> &wi,
                                       Spectrum *f) const {
        if (Grazing(wo) || Grazing(wi) || (row.Closed() && !SameSide(wo, wi))) {
            *f = {};
            return;
        }
        const T scale = 1 / (std::numbers::pi_v<T> * std::abs(wo.z) * std::abs(wi.z));
        Spectrum integral;
        Quadrature::Integrate(row, bend, films, wo, wi, &integral);
        for (int i = 0; i < N; ++i)
            integral[i] = Finite(melanin[i] * scale * integral[i]);
        *f = integral;
    }

    /// Density of wi among the mirror directions of the facets that wo sees, 1/sr.
    [[gnu::noinline]] T MirrorDensity(Direction<T> wo, Direction<T> wi) const {
        const Direction<T> m = Between(wo, wi);
        if (!bend.MayHaveNormal(m)) return 0;
        const Facet<T> facet = FacetTowards(m, std::sqrt(Dot(m, m)));
        if (!Sees(row, bend, wo, facet)) return 0;
        return FacetDensity(row, bend, facet) / (4 * std::abs(wo.z));
    }

    /// Along the normal that mirrors wo into wi.
    static Direction<T> Between(Direction<T> wo, Direction<T> wi) {
        return {wo.x + wi.x, wo.y + wi.y, wo.z + wi.z};
    }
    /// The facet with the normal m = Between(wo, wi); at the pole, where nothing is seen, if the
    /// two are opposite and their sum has no direction that could be trusted.
    Facet<T> FacetTowards(Direction<T> m, T length) const {
        if (length < 16 * std::numeric_limits<T>::epsilon()) return {};
        return FacetWithNormal(row, m, length);
    }

    /// p_t: the share of TRT in what a flat film of random thickness would return, by the
    /// wavelengths' mean index and melanin. Beyond 70 degrees the facets that are seen face wo
    /// better than the vane does (at 85 degrees TRT returns 2 to 15 % of the light, the flat film
    /// 0.5 %), so that cosine is the least.
    T PigmentChance(T cosine) const {
        const auto [rho, through] = averageFilm.At(std::clamp(cosine, T(0.35), T(1)));
        // Both times the square of rho + through.
        const T tau = meanMelanin * through * through, reflected = rho * (rho + through);
        return tau > 0 ? tau / (tau + reflected) : T(0);
    }

    /// The lobes for TRT are cosines about the vane's normal on wo's side, about the mean visible
    /// normal, and about the other side's normal: together they miss nothing that f_TRT reaches.
    /// Chances 50/45/5 %; a closed row lets nothing through and has the first two only.
    static constexpr T kVaneLobe = T(0.5);
    T ThroughLobe() const { return row.Closed() ? T(0) : T(0.05); }

    T PigmentLobe(const View<T> &view, Direction<T> wi) const {
        const T above = std::copysign(T(1), view.wo.z) * wi.z;
        const T vane = above > 0 ? kVaneLobe * above : -ThroughLobe() * above;
        const T mean = std::max(T(0), Dot(view.meanNormal, wi));
        return (vane + (1 - kVaneLobe - ThroughLobe()) * mean) / std::numbers::pi_v<T>;
    }

    Direction<T> SamplePigment(const View<T> &view, T uc, T u0, T u1) const {
        const T side = std::copysign(T(1), view.wo.z);
        const Direction<T> axis = uc < kVaneLobe           ? Direction<T>{0, 0, side}
                                  : uc < 1 - ThroughLobe() ? view.meanNormal
                                                           : Direction<T>{0, 0, -side};
        // A point of the unit sphere about the axis' tip lies in a cosine-distributed direction.
        const T z = 1 - 2 * u0, radius = std::sqrt(std::max(T(0), 1 - z * z));
        const T angle = 2 * std::numbers::pi_v<T> * u1;
        return Normalized(
            {axis.x + radius * std::cos(angle), axis.y + radius * std::sin(angle), axis.z + z},
            axis);
    }

    /// The normal of the chord between the first and the last point that wo sees, in the segment
    /// that halves its view of the arc.
    Direction<T> MeanNormal(Direction<T> wo) const {
        const Direction<T> vane{0, 0, std::copysign(T(1), wo.z)};
        if (Grazing(wo)) return vane;
        const auto [middle, rSqr, along] = bend.MiddleSeenFrom(wo);
        const RowView<T> seen = row.SeenFrom(Planar<T>{along, wo.x});
        // Of any length: nothing is divided.
        const Planar<T> e = seen.ScaledPointAt((seen.lower + seen.upper) / 2);
        const Planar<T> n = row.FromAxes({e.n, row.Aspect() * e.x});
        return Normalized({n.x * rSqr, n.n * middle.x, n.n * middle.n}, vane,
                          seen.reach * seen.reach * rSqr);
    }

    /// w with length 1; `otherwise` if it is shorter than rounding leaves vectors of length `unit`.
    static Direction<T> Normalized(Direction<T> w, Direction<T> otherwise, T unit = 1) {
        const T lengthSqr = Dot(w, w), least = std::numeric_limits<T>::epsilon() * unit;
        if (!(lengthSqr > least * least)) return otherwise;
        const T scale = 1 / std::sqrt(lengthSqr);
        return {w.x * scale, w.y * scale, w.z * scale};
    }

    Sample<T, N> GapSample(const View<T> &view) const {
        Sample<T, N> sample{-view.wo, {}, 1 - view.pigmentChance, true};
        sample.f.fill(1 / std::abs(view.wo.z));
        return sample;
    }

    Row<T> row;
    Bend<T> bend;
    std::array<Film<T>, N> films;
    Spectrum melanin;
    T meanMelanin;
    AverageFilm<T> averageFilm;  ///< of the mean index
};

}  // namespace pbrt::feather
