#include "pbrt/bxdfs/hair_bxdf.h"

#include <gtest/gtest.h>

#include "bxdf/kronecker.h"
#include "pbrt/bxdfs/hair_absorption.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt {
namespace {

// Suite, sweeps and bounds of pbrt-v4's Hair tests (PBRT_FORMAT 5.1), with scales that are tilted
// as well as not; eta is 1.55 throughout.

constexpr float kEta = 1.55f;
constexpr float kTilts[]{0, 2, -5};
constexpr float kOdd[]{0.1f, 0.3f, 0.5f, 0.7f, 0.9f};
constexpr TransportMode kMode = TransportMode::Radiance;
using test::Kronecker;

float AcrossFibre(float u) {
    return std::clamp(2 * u - 1, -0.999999f, 0.999999f);
}
HairBxDF White(float h, float beta_m, float beta_n, float alpha) {
    return HairBxDF(h, kEta, SampledSpectrum(0), beta_m, beta_n, alpha);
}

/// Without absorption all light comes out again: uniform directions.
TEST(Hair, WhiteFurnace) {
    Rng rng(1);
    for (float alpha : kTilts) {
        for (float beta_m : kOdd) {
            for (float beta_n : kOdd) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                // Of uniform directions few meet the narrowest lobes.
                const int n = beta_m + beta_n < 0.3f           ? 1000000
                              : beta_m < 0.5f || beta_n < 0.5f ? 100000
                                                               : 20000;
                double sum = 0;
                for (int i = 0; i < n; ++i) {
                    const Kronecker u(i);
                    const Vector3f wi = SampleUniformSphere({u[1], u[2]});
                    const SampledSpectrum f =
                        White(AcrossFibre(u[0]), beta_m, beta_n, alpha).f(wo, wi, kMode);
                    sum += double(f.Average()) * AbsCosTheta(wi) / UniformSpherePDF;
                }
                EXPECT_NEAR(sum / n, 1, 0.05) << beta_m << " " << beta_n << " " << alpha;
            }
        }
    }
}

TEST(Hair, WhiteFurnaceSampled) {
    Rng rng(2);
    for (float alpha : kTilts) {
        for (float beta_m : kOdd) {
            for (float beta_n : kOdd) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                const int n = 10000;
                double sum = 0;
                for (int i = 0; i < n; ++i) {
                    const Kronecker u(i);
                    const auto s = White(AcrossFibre(u[0]), beta_m, beta_n, alpha)
                                       .Sample_f(wo, u[1], {u[2], u[3]}, kMode);
                    if (s) sum += double(s->f.Average()) * AbsCosTheta(s->wi) / s->pdf;
                }
                EXPECT_NEAR(sum / n, 1, 0.01) << beta_m << " " << beta_n << " " << alpha;
            }
        }
    }
}

/// Without absorption lobes are drawn in exact proportion: no sample's weight differs from 1.
TEST(Hair, SamplingWeights) {
    for (float alpha : kTilts) {
        for (float beta_m : kOdd) {
            for (float beta_n : {0.4f, 0.6f, 0.8f}) {
                for (int i = 0; i < 10000; ++i) {
                    const Kronecker u(i), v(i + 77);
                    const Vector3f wo = SampleUniformSphere({u[1], u[2]});
                    const auto s = White(AcrossFibre(u[0]), beta_m, beta_n, alpha)
                                       .Sample_f(wo, u[3], {u[4], v[0]}, kMode);
                    ASSERT_TRUE(s);
                    EXPECT_NEAR(s->f.Average() * AbsCosTheta(s->wi) / s->pdf, 1, 0.01);
                }
            }
        }
    }
}

/// The same integral by sampling and by uniform directions, under light that is not uniform.
TEST(Hair, SamplingConsistency) {
    Rng rng(3);
    const auto light = [](Vector3f w) { return Sqr(double(w.z)); };
    const SampledSpectrum sigma_a(std::array<float, 4>{0.25f, 0.1f, 0.6f, 2});
    for (float alpha : kTilts) {
        for (float beta_m : {0.2f, 0.4f, 0.6f, 0.8f}) {
            for (float beta_n : {0.4f, 0.6f, 0.8f}) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                const int n = 65536;
                double uniform = 0, sampled = 0;
                for (int i = 0; i < n; ++i) {
                    const Kronecker u(i);
                    const HairBxDF hair(2 * u[0] - 1, kEta, sigma_a, beta_m, beta_n, alpha);
                    const auto s = hair.Sample_f(wo, u[1], {u[2], u[3]}, kMode);
                    if (s) sampled += s->f.Average() * AbsCosTheta(s->wi) / s->pdf * light(s->wi);
                    const Vector3f wi = SampleUniformSphere({u[1], u[2]});
                    uniform += hair.f(wo, wi, kMode).Average() * AbsCosTheta(wi) * light(wi) /
                               UniformSpherePDF;
                }
                EXPECT_NEAR(sampled / uniform, 1, 0.05) << beta_m << " " << beta_n;
            }
        }
    }
}

TEST(Hair, HOnTheEdge) {
    for (float h : {-1.f, 1.f, -1.0000001f}) {
        for (float beta : {0.01f, 0.1f, 1.f}) {
            const HairBxDF hair(h, kEta, SampledSpectrum(0.5f), beta, beta, 2);
            Rng rng(4);
            for (int i = 0; i < 1000; ++i) {
                const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
                const Vector3f wi = SampleUniformSphere(rng.Uniform2D());
                EXPECT_TRUE(hair.f(wo, wi, kMode).IsFinite());
                EXPECT_TRUE(std::isfinite(hair.PDF(wo, wi, kMode)));
                const auto s = hair.Sample_f(wo, rng.Uniform(), rng.Uniform2D(), kMode);
                EXPECT_TRUE(!s || (s->f.IsFinite() && s->pdf > 0));
            }
        }
    }
}

/// Power scattered, by sampling, as a share of what comes in.
SampledSpectrum Albedo(SampledSpectrum sigma_a, Vector3f wo) {
    const int n = 20000;
    SampledSpectrum sum;
    for (int i = 0; i < n; ++i) {
        const Kronecker u(i);
        const auto s = HairBxDF(2 * u[0] - 1, kEta, sigma_a, 0.3f, 0.3f, 2)
                           .Sample_f(wo, u[1], {u[2], u[3]}, kMode);
        if (s) sum += s->f * (AbsCosTheta(s->wi) / s->pdf);
    }
    return sum / n;
}

TEST(Hair, AbsorptionDarkensDownToTheSurfacesReflectance) {
    const Vector3f wo = Normalize(Vector3f{0.3f, 0.4f, 0.9f});
    const SampledSpectrum a = Albedo(SampledSpectrum(std::array<float, 4>{0, 0.1f, 1, 1e4f}), wo);
    EXPECT_NEAR(a[0], 1, 0.01);
    EXPECT_TRUE(a[0] > a[1] && a[1] > a[2] && a[2] > a[3]);
    // Nothing but R: Fresnel's reflectance averaged across the fibre.
    const float cos_o = std::sqrt(1 - Sqr(wo.x));
    double reflected = 0;
    for (int i = 0; i < 1000; ++i)
        reflected += FrDielectric(cos_o * std::sqrt(1 - Sqr((i + 0.5f) / 1000)), kEta).R / 1000;
    EXPECT_NEAR(a[3], reflected, 2e-3);
}

/// With straight scales, at equal inclinations, going back along the other side of the fibre.
TEST(Hair, ReciprocalAtEqualInclinations) {
    Rng rng(5);
    const SampledSpectrum sigma_a(0.3f);
    for (int i = 0; i < 10000; ++i) {
        const Vector3f wo = SampleUniformSphere(rng.Uniform2D());
        const SinCos turn = SinCosTurns(rng.Uniform());
        const float cos_o = std::sqrt(Sqr(wo.y) + Sqr(wo.z));
        const Vector3f wi{i % 2 ? wo.x : -wo.x, cos_o * turn.cos, cos_o * turn.sin};
        const float h = 2 * rng.Uniform() - 1;
        const HairBxDF there(h, kEta, sigma_a, 0.3f, 0.4f, 0),
            back(-h, kEta, sigma_a, 0.3f, 0.4f, 0);
        const float f = there.f(wo, wi, kMode)[0] * AbsCosTheta(wi);
        const float g = back.f(wi, wo, kMode)[0] * AbsCosTheta(wo);
        EXPECT_NEAR(f, g, 1e-4f * g + 1e-6f);
    }
}

/// A ray through the middle of a smooth fibre goes on straight (TT), back (R, TRT): the peaks are
/// where geometrical optics has them.
TEST(Hair, PeaksOfSmoothFibres) {
    const HairBxDF hair(0.5f, kEta, SampledSpectrum(0), 0.05f, 0.05f, 0);
    const float gamma_o = std::asin(0.5f), gamma_t = std::asin(0.5f / kEta);
    for (int p : {0, 1, 2}) {
        const float peak = 2 * p * gamma_t - 2 * gamma_o + p * Pi;
        const auto at = [&](float phi) {
            // wo across the fibre; 0.01 off its plane so that no direction has z = 0.
            const Vector3f wo{0, std::cos(0.3f), std::sin(0.3f)};
            const Vector3f wi{0, std::cos(0.3f + phi), std::sin(0.3f + phi)};
            return hair.f(wo, wi, kMode)[0] * AbsCosTheta(wi);
        };
        EXPECT_GT(at(peak), 2 * at(peak + 0.1f)) << p;
        EXPECT_GT(at(peak), 2 * at(peak - 0.1f)) << p;
    }
}

TEST(Hair, AbsorptionFromColourIsFiniteAndMonotonic) {
    const SampledSpectrum colours(std::array<float, 4>{0, 0.1f, 0.5f, 1});
    for (float beta_n : {0.01f, 0.3f, 1.f}) {
        const SampledSpectrum s = SigmaAFromReflectance(colours, beta_n);
        EXPECT_TRUE(s.IsFinite());
        EXPECT_TRUE(s[0] > s[1] && s[1] > s[2] && s[2] > s[3]);
        EXPECT_EQ(s[3], 0);
    }
    // (ln 0.5 / (5.969 - 0.0645 + 0.22788 - 0.28971 + 0.0451494 + 0.00059535))^2
    EXPECT_NEAR(SigmaAFromReflectance(colours, 0.3f)[2], Sqr(std::log(0.5) / 5.88841475), 1e-7);
}

TEST(Hair, AbsorptionFromMelanin) {
    EXPECT_EQ(SigmaAFromConcentration(0, 0), (RGB{0, 0, 0}));
    const RGB s = SigmaAFromConcentration(1.3f, 0.5f);
    EXPECT_FLOAT_EQ(s.r, 1.3f * 0.419f + 0.5f * 0.187f);
    EXPECT_FLOAT_EQ(s.g, 1.3f * 0.697f + 0.5f * 0.4f);
    EXPECT_FLOAT_EQ(s.b, 1.3f * 1.37f + 0.5f * 1.05f);
}

}  // namespace
}  // namespace pbrt
