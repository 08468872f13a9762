// CoatedDiffuseBxDF against a slow twin: light walked from layer to layer.

#include <string>

#include "pbrt/bxdfs/coated_diffuse_bxdf.h"

#include <gtest/gtest.h>

#include "bxdf/bands.h"
#include "pbrt/bxdfs/dielectric_bxdf.h"
#include "pbrt/util/rng.h"

namespace pbrt::test {
namespace {

constexpr auto kMode = TransportMode::Importance;  // power: nothing is scaled by indices

struct Layers {
    std::string name;
    float eta, depth, alphaX, alphaY, rho;
    double tolerance;  ///< of a share of all light
    bool textured = false;
};

/// What comes up of light from wo, its first reflection by the coat left out: by walks.
Bands Walked(const Layers &l, Vector3f wo, int n) {
    const DielectricBxDF coat(l.eta, l.alphaX, l.alphaY);
    Rng rng(31);
    const auto pass = [&](Vector3f w, double *weight) -> std::optional<Vector3f> {
        const float uc = rng.Uniform();
        const auto s = coat.Sample_f(w, uc, rng.Uniform2D(), kMode);
        if (!s) return {};
        *weight *= s->f[0] * AbsCosTheta(s->wi) / s->pdf;
        return s->wi;
    };
    Bands bands;
    for (int i = 0; i < n; ++i) {
        double weight = 1.0 / n;
        std::optional<Vector3f> w = pass(wo, &weight);
        for (int depth = 0; w && w->z < 0 && depth < 1000; ++depth) {
            weight *= l.rho * std::exp(-l.depth / AbsCosTheta(*w));
            const Vector3f up = SampleCosineHemisphere(rng.Uniform2D());
            if (!(up.z > 0)) break;
            weight *= std::exp(-l.depth / up.z);
            // The boundary is met from below: w points back to the base.
            w = pass(-up, &weight);
            if (w && w->z > 0) bands.Add(w->z, weight);
        }
    }
    return bands;
}

/// The same from f: the base's part alone, by taking off f over a black base.
Bands Evaluated(const Layers &l, Vector3f wo) {
    const Coat coat =
        l.textured ? Coat::ForTextures(l.eta, l.depth) : Coat(l.eta, l.depth, l.alphaX, l.alphaY);
    const CoatedDiffuseBxDF whole(SampledSpectrum(l.rho), coat, l.alphaX, l.alphaY),
        black(SampledSpectrum(0), coat, l.alphaX, l.alphaY);
    constexpr int kCosines = 200, kAzimuths = 60;
    Bands bands;
    for (int i = 0; i < kCosines; ++i) {
        for (int j = 0; j < kAzimuths; ++j) {
            const float c = std::sqrt((float(i) + 0.5f) / kCosines), s = SafeSqrt(1 - Sqr(c));
            const SinCos phi = SinCosTurns((float(j) + 0.5f) / kAzimuths);
            const Vector3f wi{s * phi.cos, s * phi.sin, c};
            const double f = double(whole.f(wo, wi, kMode)[0]) - black.f(wo, wi, kMode)[0];
            bands.Add(c, f * Pi / (kCosines * kAzimuths));
        }
    }
    return bands;
}

class CoatedDiffuse : public testing::TestWithParam<Layers> {};

/// 400000 walks: standard errors up to 8e-4 of all light; tolerances are 4 of those and the errors
/// measured with 2e7 walks, at most 1.6e-3 in all (but for textured facets longer than wide).
TEST_P(CoatedDiffuse, AgreesWithWalks) {
    const Layers &l = GetParam();
    ExpectSameBands(l.name, l.tolerance, [&](Vector3f wo, int n) {
        return std::pair(Evaluated(l, wo), Walked(l, wo, n));
    });
}

INSTANTIATE_TEST_SUITE_P(
    Layers, CoatedDiffuse,
    testing::Values(Layers{"Smooth", 1.5f, 0, 0, 0, 0.8f, 4e-3},
                    Layers{"SmoothThick", 1.5f, 0.3f, 0, 0, 1, 4e-3},
                    Layers{"Default", 1.5f, 0.01f, 0, 0, 0.5f, 4e-3},
                    Layers{"Sharp", 1.5f, 0.01f, 0.03f, 0.03f, 0.9f, 4e-3},
                    Layers{"Rough", 1.5f, 0.01f, 0.3f, 0.3f, 0.9f, 4e-3},
                    Layers{"RoughThick", 1.8f, 0.5f, 0.5f, 0.5f, 0.9f, 4e-3},
                    Layers{"VeryRough", 1.5f, 0.01f, 1, 1, 0.9f, 4e-3},
                    Layers{"Brushed", 1.5f, 0.01f, 0.1f, 0.5f, 0.9f, 4e-3},
                    Layers{"TexturedSmooth", 1.5f, 0.01f, 0, 0, 0.9f, 4e-3, true},
                    Layers{"TexturedSharp", 1.5f, 0.01f, 0.03f, 0.03f, 0.9f, 4e-3, true},
                    Layers{"TexturedRough", 1.5f, 0.01f, 0.35f, 0.35f, 0.9f, 4e-3, true},
                    Layers{"TexturedBrushed", 1.5f, 0.01f, 0.1f, 0.5f, 0.9f, 2.5e-2, true}),
    [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace pbrt::test
