#include <cmath>

#include "bxdf/bxdf_types.h"

namespace pbrt::test {
namespace {

bool IsNonNegative(const SampledSpectrum &s) {
    return s[0] >= 0 && s[1] >= 0 && s[2] >= 0 && s[3] >= 0;
}

template <typename B>
class EveryBxDF : public testing::Test {};
TYPED_TEST_SUITE(EveryBxDF, BxDFTypes);

Vector3f RandomDirection(Rng &rng) {
    return SampleUniformSphere(rng.Uniform2D());
}

TYPED_TEST(EveryBxDF, SamplesCarryTheirOwnFAndPDF) {
    for (const auto &c : CasesOf<TypeParam>()) {
        for (TransportMode mode : kModes) {
            Rng rng(21);
            for (int i = 0; i < 20000; ++i) {
                const Vector3f wo = RandomDirection(rng);
                const auto s = c.bxdf.Sample_f(wo, rng.Uniform(), rng.Uniform2D(), mode);
                if (!s) continue;
                ASSERT_GT(s->pdf, 0) << c;
                EXPECT_NEAR(Length(s->wi), 1, 1e-5f) << c;
                const SampledSpectrum f = c.bxdf.f(wo, s->wi, mode);
                const float pdf = c.bxdf.PDF(wo, s->wi, mode);
                if (IsSpecular(s->flags)) continue;
                // At grazing the half vector loses the digits that the directions have lost.
                const float slack = 1 + 0.02f / std::min(std::abs(wo.z), std::abs(s->wi.z));
                EXPECT_NEAR(pdf / s->pdf, 1, c.sampleTolerance * slack) << c;
                for (int l = 0; l < NSpectrumSamples; ++l) {
                    EXPECT_NEAR(f[l], s->f[l], c.sampleTolerance * slack * s->f[l] + 1e-6f * pdf)
                        << c;
                }
            }
        }
    }
}

TYPED_TEST(EveryBxDF, FlagsTellTheTruth) {
    for (const auto &c : CasesOf<TypeParam>()) {
        const BxDFFlags flags = c.bxdf.Flags();
        Rng rng(22);
        for (int i = 0; i < 5000; ++i) {
            const Vector3f wo = RandomDirection(rng), wi = RandomDirection(rng);
            const auto s =
                c.bxdf.Sample_f(wo, rng.Uniform(), rng.Uniform2D(), TransportMode::Radiance);
            if (s) {
                EXPECT_EQ(uint8_t(s->flags) &
                              ~uint8_t(flags | BxDFFlags::NullTransmission | BxDFFlags::Specular),
                          0)
                    << c;
                const bool same = SameHemisphere(wo, s->wi);
                EXPECT_EQ(IsReflective(s->flags), same) << c;
                EXPECT_EQ(IsTransmissive(s->flags), !same) << c;
                EXPECT_TRUE(IsSpecular(s->flags) != IsNonSpecular(s->flags)) << c;
            }
            const SampledSpectrum f = c.bxdf.f(wo, wi, TransportMode::Radiance);
            const bool sideClaimed =
                SameHemisphere(wo, wi) ? IsReflective(flags) : IsTransmissive(flags);
            EXPECT_TRUE(!f || (sideClaimed && IsNonSpecular(flags))) << c;
        }
    }
}

/// What is scattered can be sampled: else the estimate misses it.
TYPED_TEST(EveryBxDF, PDFIsPositiveWhereFIs) {
    for (const auto &c : CasesOf<TypeParam>()) {
        Rng rng(23);
        for (int i = 0; i < 20000; ++i) {
            const Vector3f wo = RandomDirection(rng), wi = RandomDirection(rng);
            const SampledSpectrum f = c.bxdf.f(wo, wi, TransportMode::Radiance);
            const float pdf = c.bxdf.PDF(wo, wi, TransportMode::Radiance);
            EXPECT_GE(pdf, 0) << c;
            EXPECT_TRUE(IsNonNegative(f)) << c;
            if (pdf == 0) {
                EXPECT_LT(f.MaxComponentValue(), 1e-15f) << c;
            }
        }
    }
}

/// Power scattered out of what comes from one direction, by samples; in importance mode, where
/// nothing is scaled by indices. One-sided, 5 standard deviations.
TYPED_TEST(EveryBxDF, ScattersNoMoreThanItReceives) {
    for (const auto &c : CasesOf<TypeParam>()) {
        for (const Vector3f &wo : Outgoing(10)) {
            Rng rng(24);
            const int n = 16384;
            double sum = 0, squares = 0;
            for (int i = 0; i < n; ++i) {
                const auto s =
                    c.bxdf.Sample_f(wo, rng.Uniform(), rng.Uniform2D(), TransportMode::Importance);
                if (!s) continue;
                const double x = s->f.MaxComponentValue() * AbsCosTheta(s->wi) / s->pdf;
                sum += x, squares += x * x;
            }
            const double mean = sum / n,
                         deviation = std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
            EXPECT_LE(mean, 1 + 5 * deviation + 1e-4) << c << " wo.z " << wo.z;
        }
    }
}

TYPED_TEST(EveryBxDF, IsReciprocal) {
    for (const auto &c : CasesOf<TypeParam>()) {
        if (!c.reciprocal) continue;
        Rng rng(25);
        for (int i = 0; i < 20000; ++i) {
            const Vector3f wo = RandomDirection(rng), wi = RandomDirection(rng);
            const float n_o = wo.z > 0 ? 1 : c.eta, n_i = wi.z > 0 ? 1 : c.eta;
            const SampledSpectrum there = c.bxdf.f(wo, wi, TransportMode::Radiance) / Sqr(n_o);
            const SampledSpectrum back = c.bxdf.f(wi, wo, TransportMode::Radiance) / Sqr(n_i);
            const SampledSpectrum adjoint = c.bxdf.f(wi, wo, TransportMode::Importance) / Sqr(n_o);
            const float slack =
                c.sampleTolerance * (1 + 0.02f / std::min(std::abs(wo.z), std::abs(wi.z)));
            for (int l = 0; l < NSpectrumSamples; ++l) {
                EXPECT_NEAR(there[l], back[l], slack * back[l] + 1e-9f) << c;
                EXPECT_NEAR(there[l], adjoint[l], slack * there[l] + 1e-9f) << c;
            }
        }
    }
}

/// All that a BxDF answers to one set of inputs. Not inlined: two inlined copies may be contracted
/// to fused multiply-adds in different ways, which is the compiler's business.
template <typename B>
[[gnu::noinline]] std::vector<float> Answers(const B &bxdf, Vector3f wo, Vector3f wi, float uc,
                                             Point2f u) {
    std::vector<float> answers{bxdf.PDF(wo, wi, TransportMode::Radiance)};
    const SampledSpectrum f = bxdf.f(wo, wi, TransportMode::Radiance);
    for (int l = 0; l < NSpectrumSamples; ++l)
        answers.push_back(f[l]);
    const auto s = bxdf.Sample_f(wo, uc, u, TransportMode::Radiance);
    if (!s) return answers;
    answers.insert(answers.end(), {s->pdf, s->wi.x, s->wi.y, s->wi.z});
    for (int l = 0; l < NSpectrumSamples; ++l)
        answers.push_back(s->f[l]);
    return answers;
}

TYPED_TEST(EveryBxDF, SameInputsGiveTheSameBits) {
    for (const auto &c : CasesOf<TypeParam>()) {
        const auto copy = c.bxdf;
        Rng rng(26);
        for (int i = 0; i < 1000; ++i) {
            const Vector3f wo = RandomDirection(rng), wi = RandomDirection(rng);
            const float uc = rng.Uniform();
            const Point2f u = rng.Uniform2D();
            EXPECT_EQ(Answers(c.bxdf, wo, wi, uc, u), Answers(copy, wo, wi, uc, u)) << c;
        }
    }
}

/// Directions where formulas tend to divide by 0: along the axes, grazing by ever less, equal and
/// opposite ones.
std::vector<Vector3f> HardDirections() {
    std::vector<Vector3f> directions;
    for (float z : {1.f, -1.f, 0.7f, -0.7f, 0x1p-12f, -0x1p-12f, 1e-7f, -1e-7f, 1e-20f, -1e-20f,
                    1e-38f, -1e-44f, 0.f, -0.f}) {
        for (const auto &[x, y] : {std::pair{1.f, 0.f}, {0.f, -1.f}, {-1.f, 0.f}, {0.6f, 0.8f}}) {
            const float r = std::sqrt(std::max(0.f, 1 - z * z));
            directions.push_back({r * x, r * y, z});
        }
    }
    return directions;
}

template <typename B>
void ExpectFiniteSample(const BxDFCase<B> &c, Vector3f wo, float uc, Point2f u) {
    for (TransportMode mode : kModes) {
        const auto s = c.bxdf.Sample_f(wo, uc, u, mode);
        if (!s) continue;
        EXPECT_TRUE(s->f.IsFinite() && IsNonNegative(s->f)) << c;
        EXPECT_TRUE(std::isfinite(s->pdf) && s->pdf > 0) << c << " pdf " << s->pdf;
        EXPECT_NEAR(Length(s->wi), 1, 1e-4f) << c;
        EXPECT_NE(s->wi.z, 0) << c;
        EXPECT_TRUE((s->f * (AbsCosTheta(s->wi) / s->pdf)).IsFinite()) << c;
    }
}

TYPED_TEST(EveryBxDF, IsFiniteAtTheCorners) {
    const std::vector<Vector3f> directions = HardDirections();
    const float corners[]{0, 0x1p-24f, 0.5f, OneMinusEpsilon};
    for (auto c : CasesOf<TypeParam>()) {
        for (bool regularized : {false, true}) {
            if (regularized) Regularize(c.bxdf);
            for (const Vector3f &wo : directions) {
                for (const Vector3f &wi : directions) {
                    for (TransportMode mode : kModes) {
                        const SampledSpectrum f = c.bxdf.f(wo, wi, mode);
                        EXPECT_TRUE(f.IsFinite() && IsNonNegative(f))
                            << c << " wo.z " << wo.z << " wi.z " << wi.z << " f " << f[0];
                        const float pdf = c.bxdf.PDF(wo, wi, mode);
                        EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0)
                            << c << " wo.z " << wo.z << " wi.z " << wi.z << " pdf " << pdf;
                    }
                }
                for (float uc : corners) {
                    for (float a : corners) {
                        for (float b : corners)
                            ExpectFiniteSample(c, wo, uc, {a, b});
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace pbrt::test
