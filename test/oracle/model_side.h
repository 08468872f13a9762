#pragma once

#include <numbers>
#include <random>
#include <vector>

#include "feather/model.h"
#include "oracle/bent_row.h"
#include "oracle/direction_bins.h"
#include "oracle/statistics.h"
#include "oracle/vector.h"

namespace pbrt::oracle {

/// The model of src/pbrt/feather in double at one wavelength, and what the twins need to know of
/// it: integrals of its R, Pdf and TRT over bins of directions. None of it uses the model's own
/// sampler.
class ModelSide {
  public:
    using Model = feather::Barbule<double, 1, feather::Converged<1, 1>>;
    static constexpr double kLambda = 520;

    ModelSide(const feather::Shape &shape, double eta, double melanin)
        : model(feather::ParamsOf<double>(shape), {{kLambda}, {eta}, {melanin}}),
          film({kLambda}, {shape.thickness}, eta),
          row(shape.spacing, shape.tilt, shape.aspect, Opening(shape)),
          shape(shape) {}

    /// MODEL 4.3 takes a straight row for one of this opening.
    static double Opening(const feather::Shape &shape) { return std::max(shape.opening, 1e-3); }

    double Gap(Vec3 w) const { return model.GapFraction(ToModel(w)); }

    struct Reflected {
        Estimate all;       ///< integral of R |wi.z|
        Estimate facets;    ///< integral of Pdf; the melanin must be 0
        Estimate mirrored;  ///< as `all`, for a film that reflects everything
        std::vector<Estimate> bins, facetBins;
    };

    /// Integrates over the facets' normals m, of which every direction wi = Mirrored(-wo, m) has
    /// one: dwi = 4 |m.wo| dm and dm = |cos gamma| da dgamma.
    Reflected IntegrateR(Vec3 wo, const DirectionBins &directions, std::uint64_t seed,
                         int samples) const {
        const std::size_t n = directions.Size();
        Replicates tally(3 + 2 * n);
        std::mt19937_64 random(seed);
        for (int replicate = 0; replicate < kReplicates; ++replicate) {
            ForEachFacet(wo, random, samples, [&](Vec3 wi, double cosine, double dwi) {
                const double r = R(wo, wi) * std::abs(wi.z) * dwi, pdf = Pdf(wo, wi) * dwi;
                const double share = film.Reflectance(cosine);
                tally.Add(0, r);
                tally.Add(1, pdf);
                if (share > 0) tally.Add(2, r / share);
                tally.Add(3 + directions(wi), r);
                tally.Add(3 + n + directions(wi), pdf);
            });
            tally.Close(samples);
        }
        return {tally[0], tally[1], tally[2], tally.Part(3, n), tally.Part(3 + n, n)};
    }

    /// Bins in which a film that reflects a share of everything would send about equal power.
    DirectionBins ReflectedBins(Vec3 wo, int azimuths, int heights) const {
        std::vector<DirectionBins::Ray> pilot;
        std::mt19937_64 random(1);
        ForEachFacet(wo, random, 20000, [&](Vec3 wi, double, double dwi) {
            const double power = Pdf(wo, wi) * dwi;
            if (power > 0) pilot.push_back({wi, power});
        });
        return DirectionBins(std::move(pilot), azimuths, heights);
    }

    struct Scattered {
        Estimate all;  ///< integral of TRT |wi.z|
        std::vector<Estimate> bins;
    };

    Scattered IntegrateTRT(Vec3 wo, const DirectionBins &directions, std::uint64_t seed,
                           int samples) const {
        Replicates tally(1 + directions.Size());
        std::mt19937_64 random(seed);
        for (int replicate = 0; replicate < kReplicates; ++replicate) {
            ForEachDirection(random, samples, [&](Vec3 wi, double dwi) {
                const double power = TRT(wo, wi) * dwi;
                tally.Add(0, power);
                tally.Add(1 + directions(wi), power);
            });
            tally.Close(samples);
        }
        return {tally[0], tally.Part(1, directions.Size())};
    }

    DirectionBins ScatteredBins(Vec3 wo, int azimuths, int heights) const {
        std::vector<DirectionBins::Ray> pilot;
        std::mt19937_64 random(2);
        ForEachDirection(random, 500, [&](Vec3 wi, double dwi) {
            const double power = TRT(wo, wi) * dwi;
            if (power > 0) pilot.push_back({wi, power});
        });
        return DirectionBins(std::move(pilot), azimuths, heights);
    }

    double R(Vec3 wo, Vec3 wi) const {
        return model.R(model.SeenFrom(ToModel(wo)), ToModel(wi))[0];
    }
    double TRT(Vec3 wo, Vec3 wi) const {
        return model.TRT(model.SeenFrom(ToModel(wo)), ToModel(wi))[0];
    }
    double Pdf(Vec3 wo, Vec3 wi) const {
        return model.Pdf(model.SeenFrom(ToModel(wo)), ToModel(wi));
    }

    const Model &Barbule() const { return model; }

  private:
    static feather::Direction<double> ToModel(Vec3 w) { return {w.x, w.y, w.z}; }

    /// visit(wi, m.wo, dwi) for facets turned to wo. Even in the eccentric angle e, which has
    /// tan(gamma - tilt) = aspect tan(e). Of the bend angles three quarters are drawn where the
    /// tracer finds light, and one quarter anywhere, so that none can be missed.
    template <class Visit>
    void ForEachFacet(Vec3 wo, std::mt19937_64 &random, int samples, const Visit &visit) const {
        EvenPoints<2> points(random);
        const double opening = Opening(shape);
        for (int i = 0; i < samples; ++i) {
            const auto [u0, u1] = points.Next();
            const double anywhere = opening * (8 * u0 - 7), e = 2 * std::numbers::pi * u1;
            const BentRow::Segment a =
                u0 < 0.75 ? row.Lit(wo, u0 / 0.75)
                          : BentRow::Segment{std::sin(anywhere), std::cos(anywhere)};
            const double density = 0.75 * row.LitDensity(wo, a) + 0.25 / (2 * opening);
            const double n = std::cos(e), x = shape.aspect * std::sin(e);
            const double gamma = shape.tilt + std::atan2(x, n), across = std::cos(gamma);
            const Vec3 m{std::sin(gamma), across * a.sin, across * a.cos};
            const double cosine = Dot(m, wo);
            if (cosine <= 0) continue;
            const double dgamma = 2 * std::numbers::pi * shape.aspect / (n * n + x * x);
            visit(Mirrored(-wo, m), cosine, 4 * cosine * std::abs(across) * dgamma / density);
        }
    }

    /// visit(wi, |wi.z| dwi), cosine-weighted over both hemispheres; `samples` is even.
    template <class Visit>
    void ForEachDirection(std::mt19937_64 &random, int samples, const Visit &visit) const {
        EvenPoints<2> points(random);
        for (int i = 0; i < samples; i += 2) {
            const auto [u0, u1] = points.Next();
            const double angle = 2 * std::numbers::pi * u0, r = std::sqrt(u1);
            for (const double side : {1, -1})
                visit(Vec3{r * std::cos(angle), r * std::sin(angle), side * std::sqrt(1 - u1)},
                      2 * std::numbers::pi);
        }
    }

    Model model;
    feather::Film<double> film;
    BentRow row;
    feather::Shape shape;
};

}  // namespace pbrt::oracle
