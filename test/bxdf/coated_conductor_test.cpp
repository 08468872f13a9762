// CoatedConductorBxDF against a slow twin: light walked from boundary to metal and back.

#include "pbrt/bxdfs/coated_conductor_bxdf.h"

#include <gtest/gtest.h>

#include <string>

#include "bxdf/bands.h"
#include "pbrt/bxdfs/conductor_bxdf.h"
#include "pbrt/bxdfs/dielectric_bxdf.h"
#include "pbrt/util/rng.h"

namespace pbrt::test {
namespace {

constexpr auto kMode = TransportMode::Importance;  // power: nothing is scaled by indices

struct Layers {
    std::string name;
    float eta, depth, alphaCoat, alphaBase, metalEta, metalK;
    double tolerance;  ///< of a share of all light, in all and for each band
};
using Alphas = CoatedConductorBxDF::Alphas;

struct Made {
    explicit Made(const Layers &l)
        : coat(l.eta, l.depth, l.alphaCoat, l.alphaCoat),
          base([&] {
              const float alpha = std::max(
                  CoatedConductorBxDF::WidenedBy(Of(l.alphaCoat), l.eta, Of(l.alphaBase)).x,
                  Coat::kSmooth);
              return CoatedBase(coat, l.alphaCoat, alpha, alpha);
          }()),
          bxdf(SampledSpectrum(l.metalEta / l.eta), SampledSpectrum(l.metalK / l.eta), coat, base,
               Of(l.alphaCoat), Of(l.alphaBase)) {}
    static Alphas Of(float alpha) { return {alpha, alpha}; }
    Coat coat;
    CoatedBase base;
    CoatedConductorBxDF bxdf;
};

/// All that comes up of light from wo, by walks through the layers.
Bands Walked(const Layers &l, Vector3f wo, int n) {
    const DielectricBxDF coat(l.eta, l.alphaCoat, l.alphaCoat);
    const ConductorBxDF metal(SampledSpectrum(l.metalEta / l.eta),
                              SampledSpectrum(l.metalK / l.eta), l.alphaBase, l.alphaBase);
    Rng rng(31);
    const auto scatter = [&](const auto &bxdf, Vector3f w, double *weight) {
        const float uc = rng.Uniform();
        const auto s = bxdf.Sample_f(w, uc, rng.Uniform2D(), kMode);
        if (!s) return Vector3f{};
        *weight *= s->f[0] * AbsCosTheta(s->wi) / s->pdf;
        return s->wi;
    };
    Bands bands;
    for (int i = 0; i < n; ++i) {
        double weight = 1.0 / n;
        Vector3f w = scatter(coat, wo, &weight);
        for (int depth = 0; w.z < 0 && depth < 1000; ++depth) {
            weight *= std::exp(-l.depth / AbsCosTheta(w));
            w = scatter(metal, -w, &weight);
            if (!(w.z > 0)) break;
            weight *= std::exp(-l.depth / w.z);
            // The boundary is met from below: w points back to the metal.
            w = scatter(coat, -w, &weight);
        }
        if (w.z > 0) bands.Add(w.z, weight);
    }
    return bands;
}

/// The same by sampling the BxDF.
Bands Sampled(const Layers &l, Vector3f wo, int n) {
    const Made made(l);
    Rng rng(7);
    Bands bands;
    for (int i = 0; i < n; ++i) {
        const float uc = rng.Uniform();
        const auto s = made.bxdf.Sample_f(wo, uc, rng.Uniform2D(), kMode);
        if (s) bands.Add(s->wi.z, s->f[0] * AbsCosTheta(s->wi) / s->pdf / n);
    }
    return bands;
}

class CoatedConductor : public testing::TestWithParam<Layers> {};

/// 400000 walks: standard errors up to 8e-4 of all light. Tolerances are 4 of those (1e-3 where
/// the closed form leaves no noise) and the errors measured.
TEST_P(CoatedConductor, AgreesWithWalks) {
    const Layers &l = GetParam();
    ExpectSameBands(l.name, l.tolerance, [&](Vector3f wo, int n) {
        return std::pair(Sampled(l, wo, n), Walked(l, wo, n));
    });
}

INSTANTIATE_TEST_SUITE_P(
    Layers, CoatedConductor,
    testing::Values(Layers{"Smooth", 1.5f, 0.01f, 0, 0, 0.2f, 3.9f, 1e-3},
                    Layers{"SmoothThick", 1.5f, 0.5f, 0, 0, 2, 4, 1e-3},
                    Layers{"Base01", 1.5f, 0.01f, 0, 0.1f, 0.2f, 3.9f, 1.6e-2},
                    Layers{"Base03", 1.5f, 0.01f, 0, 0.3f, 0.2f, 3.9f, 8e-3},
                    Layers{"Base06", 1.5f, 0.01f, 0, 0.6f, 0.2f, 3.9f, 8e-3},
                    Layers{"Base1", 1.5f, 0.01f, 0, 1, 0.2f, 3.9f, 8e-3},
                    Layers{"Paint", 1.5f, 0.06f, 0.1f, 0.45f, 1, 2, 8e-3},
                    Layers{"Both01", 1.5f, 0.01f, 0.1f, 0.1f, 0.2f, 3.9f, 7e-2},
                    Layers{"Coat03", 1.5f, 0.01f, 0.3f, 0, 0.2f, 3.9f, 0.14},
                    Layers{"Coat03Base05", 1.8f, 0.2f, 0.3f, 0.5f, 1, 2, 8e-3}),
    [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace pbrt::test
