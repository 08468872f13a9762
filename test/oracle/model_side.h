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

/// theta from the normal and phi from the x axis, in degrees.
inline Vec3 Towards(double theta, double phi) {
    const feather::Direction<double> w = feather::Spherical(theta, phi);
    return {w.x, w.y, w.z};
}

/// MODEL 4.3 takes a straight row for one of this opening.
inline double Opening(const feather::Shape &shape) {
    return std::max(shape.opening, 1e-3);
}

inline BentRow BentRowOf(const feather::Shape &s) {
    return {s.spacing, s.tilt, s.aspect, Opening(s)};
}

/// The model of src/pbrt/feather in double at one wavelength, and what the twins need to know of
/// it: integrals of its R, PDF and TRT over bins of directions. None of it uses the model's own
/// sampler.
class ModelSide {
  public:
    using Model = feather::Barbule<double, 1, feather::Converged<1, 1>>;
    static constexpr double kLambda = 520;                              ///< nm
    static constexpr double kEta = 1.532 + 5890 / (kLambda * kLambda);  ///< keratin's

    ModelSide(const feather::Shape &shape, double melanin)
        : model(feather::ParamsOf<double>(shape), {{kLambda}, {kEta}, {melanin}}),
          film({kLambda}, {shape.thickness}, kEta),
          row(BentRowOf(shape)),
          shape(shape) {}

    double Gap(Vec3 w) const { return model.GapFraction(ToModel(w)); }

    struct Reflected {
        Estimate all;       ///< integral of R |wi.z|
        Estimate facets;    ///< integral of PDF; the melanin must be 0
        Estimate mirrored;  ///< as `all`, for a film that reflects everything
        std::vector<Estimate> bins, facetBins;
    };

    /// Integrates over the facets' normals m, of which every direction wi = Mirrored(-wo, m) has
    /// one: dwi = 4 |m.wo| dm.
    Reflected IntegrateR(Vec3 wo, const DirectionBins &directions, std::uint64_t seed,
                         int samples) const {
        const std::size_t n = directions.Size();
        Replicates tally(3 + 2 * n);
        std::mt19937_64 random(seed);
        for (int replicate = 0; replicate < kReplicates; ++replicate) {
            ForEachFacet(wo, random, samples, [&](Vec3 wi, double cosine, double dwi) {
                const double r = R(wo, wi) * std::abs(wi.z) * dwi, pdf = PDF(wo, wi) * dwi;
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
            const double power = PDF(wo, wi) * dwi;
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
    double PDF(Vec3 wo, Vec3 wi) const {
        return model.PDF(model.SeenFrom(ToModel(wo)), ToModel(wi));
    }

    const Model &Barbule() const { return model; }

  private:
    static feather::Direction<double> ToModel(Vec3 w) { return {w.x, w.y, w.z}; }

    /// visit(wi, m.wo, dwi) for facets turned to wo. Half of them are drawn where the tracer's
    /// light falls, half evenly in bend angle and eccentric angle, so that none can be missed.
    template <class Visit>
    void ForEachFacet(Vec3 wo, std::mt19937_64 &random, int samples, const Visit &visit) const {
        EvenPoints<2> points(random);
        const double opening = Opening(shape), even = 1 / (4 * opening * std::numbers::pi);
        for (int i = 0; i < samples; ++i) {
            const auto [u0, u1] = points.Next();
            const double a = opening * (4 * u0 - 3);
            const auto hit = u0 < 0.5
                                 ? row.Enter(wo, 2 * u0, u1)
                                 : row.At({std::sin(a), std::cos(a)}, 2 * std::numbers::pi * u1);
            if (!hit || Dot(hit->normal, wo) <= 0) continue;
            // gamma - tilt is the angle of (cos e, aspect sin e); dm = |cos gamma| da dgamma
            const double cosine = Dot(hit->normal, wo), e = row.EccentricAngle(*hit);
            const double n = std::cos(e), x = shape.aspect * std::sin(e);
            const double dm =
                std::hypot(hit->normal.y, hit->normal.z) * shape.aspect / (n * n + x * x);
            const double density = (row.HitDensity(wo, *hit) + even) / 2;
            visit(Mirrored(-wo, hit->normal), cosine, 4 * cosine * dm / density);
        }
    }

    /// visit(wi, |wi.z| dwi) over both hemispheres, half of it cosine-weighted and half even;
    /// `samples` is even.
    template <class Visit>
    void ForEachDirection(std::mt19937_64 &random, int samples, const Visit &visit) const {
        EvenPoints<2> points(random);
        for (int i = 0; i < samples; i += 2) {
            const auto [u0, u1] = points.Next();
            const double z = u1 < 0.5 ? std::sqrt(1 - 2 * u1) : 2 * u1 - 1,
                         r = std::sqrt(1 - z * z);
            const double angle = 2 * std::numbers::pi * u0;
            for (const double side : {1, -1})
                visit(Vec3{r * std::cos(angle), r * std::sin(angle), side * z},
                      8 * std::numbers::pi * z / (2 * z + 1));
        }
    }

    Model model;
    feather::Film<double> film;
    BentRow row;
    feather::Shape shape;
};

}  // namespace pbrt::oracle
