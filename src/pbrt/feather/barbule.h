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
#include "params.h"
#include "pigment_fast.h"
#include "row.h"
#include "thin_film.h"

namespace pbrt::feather {

/// What scatters light at a vertex, seen from one direction; made by Barbule::SeenFrom.
/// Sampler, pdf and f read it, so that they cannot drift apart.
template <std::floating_point T>
struct View {
    Direction<T> wo;
    T pigmentChance;  ///< probability of the TRT lobe, p_t
    bool grazing;     ///< |wo.z| below Barbule::kGrazing: nothing is scattered
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
/// |wo.z| or |wi.z| is below kGrazing. Nothing here is random but what the caller's numbers make
/// so. `Quadrature` integrates TRT, see pigment_fast.h. Source: MODEL sections 3 to 7.
template <std::floating_point T, int N, class Quadrature = AdaptiveRule>
class Barbule {
  public:
    using Spectrum = std::array<T, N>;
    static constexpr T kGrazing = T(1e-12);

    /// `params` within kParams' ranges, `optics` within kSpectrumParams'.
    Barbule(const BarbuleParams<T> &params, const Optics<T, N> &optics)
        : row(params.spacing, params.tilt, params.aspect),
          bend(params.opening),
          melanin(optics.melanin) {
        for (int i = 0; i < N; ++i)
            films[i] = Film<T>(Nm<T>{optics.lambda[i]}, params.thickness, optics.eta[i]);
    }

    View<T> SeenFrom(Direction<T> wo) const {
        return {wo, PigmentChance(std::abs(wo.z)), std::abs(wo.z) < kGrazing};
    }

    // R, TRT, Pdf and PigmentChance are compiled once: inlined copies may round differently, and
    // near the edge of what is seen a last bit decides between 0 and all.

    /// Reflection off the film, with interference.
    [[gnu::noinline]] Spectrum R(const View<T> &view, Direction<T> wi) const {
        const Glint glint = GlintTowards(view, wi);
        if (!glint.fromWo || !glint.fromWi) return {};
        Spectrum f;
        const T scale = glint.density / (4 * std::abs(view.wo.z));
        for (int i = 0; i < N; ++i)
            f[i] = Finite(films[i].Reflectance(glint.cosine) * scale / std::abs(wi.z));
        return f;
    }

    /// In through the film, off the melanin, out through the film.
    [[gnu::noinline]] Spectrum TRT(const View<T> &view, Direction<T> wi) const {
        const Direction<T> &wo = view.wo;
        if (view.grazing || std::abs(wi.z) < kGrazing || (row.Closed() && !SameSide(wo, wi)))
            return {};
        Spectrum f = Quadrature::Integrate(row, bend, films, wo, wi);
        const T scale = 1 / (std::numbers::pi_v<T> * std::abs(wo.z));
        for (int i = 0; i < N; ++i)
            f[i] = Finite(melanin[i] * f[i] * scale / std::abs(wi.z));
        return f;
    }

    /// R + TRT; the gap is a delta and not in f.
    Spectrum f(const View<T> &view, Direction<T> wi) const {
        Spectrum sum = R(view, wi);
        const Spectrum pigment = TRT(view, wi);
        for (int i = 0; i < N; ++i)
            sum[i] += pigment[i];
        return sum;
    }

    /// Density with which SampleDirection draws wi, 1/sr, the gap's delta apart; its integral is
    /// 1 - (1 - p_t) GapFraction(wo). Exact for every opening.
    [[gnu::noinline]] T Pdf(const View<T> &view, Direction<T> wi) const {
        if (view.grazing || std::abs(wi.z) < kGrazing) return 0;
        const Glint glint = GlintTowards(view, wi);
        const T reflected = glint.fromWo ? glint.density / (4 * std::abs(view.wo.z)) : T(0);
        return Finite(view.pigmentChance * PigmentLobe(view.wo, wi) +
                      (1 - view.pigmentChance) * reflected);
    }

    /// Draws wi without evaluating f, which is left 0 except for a gap. uc, u0, u1 in [0, 1).
    std::optional<Sample<T, N>> SampleDirection(const View<T> &view, T uc, T u0, T u1) const {
        if (view.grazing) return {};
        Sample<T, N> sample{};
        if (uc < view.pigmentChance) {
            sample.wi = SamplePigment(view.wo, uc / view.pigmentChance, u0, u1);
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

    /// The facet that mirrors wo into wi.
    struct Glint {
        T density;  ///< D(m)
        T cosine;   ///< m.wi
        bool fromWo, fromWi;
    };

    static T Finite(T x) { return std::min(x, std::numeric_limits<T>::max()); }
    static bool SameSide(Direction<T> a, Direction<T> b) { return (a.z < 0) == (b.z < 0); }

    Glint GlintTowards(const View<T> &view, Direction<T> wi) const {
        const Direction<T> m{view.wo.x + wi.x, view.wo.y + wi.y, view.wo.z + wi.z};
        const T length = std::sqrt(Dot(m, m));
        if (view.grazing || std::abs(wi.z) < kGrazing || length < kOpposite) return {};
        const Facet<T> facet = FacetWithNormal(row, m, length);
        return {FacetDensity(row, bend, facet), std::min(length / 2, T(1)),
                Sees(row, bend, view.wo, facet), Sees(row, bend, wi, facet)};
    }
    /// wo + wi shorter than this has no direction that can be trusted.
    static constexpr T kOpposite = 16 * std::numeric_limits<T>::epsilon();

    /// p_t: the share of TRT in what a flat film of random thickness would return.
    [[gnu::noinline, gnu::pure]] T PigmentChance(T cosine) const {
        T pigment = 0, film = 0;
        for (int i = 0; i < N; ++i) {
            const T surface = films[i].SurfaceReflectance(std::min(cosine, T(1)));
            const T rho = 2 * surface / (1 + surface);
            film += rho;
            pigment += melanin[i] * (1 - rho) * (1 - rho);
        }
        return pigment > 0 ? pigment / (pigment + film) : T(0);
    }

    /// Chance that the lobe for TRT draws on the side of wo.
    T SameSideChance() const { return row.Closed() ? T(1) : T(0.9); }

    T PigmentLobe(Direction<T> wo, Direction<T> wi) const {
        const T chance = SameSide(wo, wi) ? SameSideChance() : 1 - SameSideChance();
        return chance * std::abs(wi.z) / std::numbers::pi_v<T>;
    }

    Direction<T> SamplePigment(Direction<T> wo, T uc, T u0, T u1) const {
        const T radius = std::sqrt(u0), angle = 2 * std::numbers::pi_v<T> * u1;
        const T side = (uc < SameSideChance()) == (wo.z > 0) ? T(1) : T(-1);
        return {radius * std::cos(angle), radius * std::sin(angle), side * std::sqrt(1 - u0)};
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
};

}  // namespace pbrt::feather
