#include <gtest/gtest.h>

#include "pbrt/spectra/spectrum.h"

namespace pbrt {
namespace {

/// Density (1/nm) of the visible importance; 0 outside [LambdaMin, LambdaMax].
/// PBRT_FORMAT section 6; integrates to 1 within 2e-7.
float VisibleWavelengthsPDF(float lambda) {
    if (!(lambda >= LambdaMin && lambda <= LambdaMax)) return 0;
    return 0.0039398042f / Sqr(std::cosh(0.0072f * (lambda - 538)));
}

/// a / b, 0 where b is 0, as for wavelengths that are terminated.
SampledSpectrum Quotient(const SampledSpectrum &a, const SampledSpectrum &b) {
    SampledSpectrum r;
    for (int i = 0; i < NSpectrumSamples; ++i)
        r.Set(i, b[i] != 0 ? a[i] / b[i] : 0);
    return r;
}

constexpr int Strata = 2000;
float Stratum(int i) {
    return (i + 0.5f) / Strata;
}

TEST(VisibleWavelengths, DensityIntegratesToOneAndVanishesOutside) {
    double sum = 0;
    for (int i = 0; i < 47000; ++i)
        sum += VisibleWavelengthsPDF(LambdaMin + (i + 0.5f) / 100) / 100;
    EXPECT_NEAR(sum, 1, 1e-5);
    EXPECT_EQ(VisibleWavelengthsPDF(std::nextafter(LambdaMin, 0.f)), 0);
    EXPECT_EQ(VisibleWavelengthsPDF(std::nextafter(LambdaMax, 1e3f)), 0);
}

TEST(VisibleWavelengths, SamplesCarryTheDensityTheyWereDrawnWith) {
    for (int i = 0; i < Strata; ++i) {
        const auto w = SampledWavelengths::SampleVisible(Stratum(i));
        for (int j = 0; j < NSpectrumSamples; ++j) {
            EXPECT_GE(w[j], LambdaMin);
            EXPECT_LE(w[j], LambdaMax);
            EXPECT_NEAR(w.PDF()[j], VisibleWavelengthsPDF(w[j]), 2e-4f * w.PDF()[j]);
        }
    }
}

TEST(VisibleWavelengths, FollowTheInverseOfTheCumulativeDensity) {
    for (const float u : {0.f, 0.2f, 0.7f, OneMinusEpsilon}) {
        const auto w = SampledWavelengths::SampleVisible(u);
        for (int j = 0; j < NSpectrumSamples; ++j) {
            const double shifted = u + j * 0.25, fraction = shifted - std::floor(shifted);
            const double lambda = 538 - 138.888889 * std::atanh(0.85691062 - 1.82750197 * fraction);
            EXPECT_NEAR(w[j], lambda, 2e-3);
        }
    }
}

TEST(UniformWavelengths, AreEquidistantWithinTheRange) {
    const auto w = SampledWavelengths::SampleUniform(0.6f, 400, 700);
    EXPECT_NEAR(w[0], 580, 1e-3);
    EXPECT_NEAR(w[1], 655, 1e-3);
    EXPECT_NEAR(w[2], 430, 1e-3);
    EXPECT_NEAR(w[3], 505, 1e-3);
    for (int j = 0; j < NSpectrumSamples; ++j)
        EXPECT_FLOAT_EQ(w.PDF()[j], 1.f / 300);
}

TEST(VisibleWavelengths, EstimateTheIntegralsOfTheMatchingFunctions) {
    double x = 0, y = 0, z = 0;
    for (int i = 0; i < Strata; ++i) {
        const auto w = SampledWavelengths::SampleVisible(Stratum(i));
        x += Quotient(spectra::X().Sample(w), w.PDF()).Average() / Strata;
        y += Quotient(spectra::Y().Sample(w), w.PDF()).Average() / Strata;
        z += Quotient(spectra::Z().Sample(w), w.PDF()).Average() / Strata;
    }
    EXPECT_NEAR(y / CIE_Y_integral, 1, 1e-3);
    // Equal energy has equal tristimulus values by the observer's definition (CIE 018:2019).
    EXPECT_NEAR(x / CIE_Y_integral, 1, 1e-3);
    EXPECT_NEAR(z / CIE_Y_integral, 1, 1e-3);
}

TEST(TerminateSecondary, LeavesOneWavelengthThatEstimatesTheSameIntegral) {
    double y = 0;
    for (int i = 0; i < Strata; ++i) {
        auto w = SampledWavelengths::SampleVisible(Stratum(i));
        EXPECT_FALSE(w.SecondaryTerminated());
        w.TerminateSecondary();
        EXPECT_TRUE(w.SecondaryTerminated());
        const auto contribution = Quotient(spectra::Y().Sample(w), w.PDF());
        for (int j = 1; j < NSpectrumSamples; ++j)
            EXPECT_EQ(contribution[j], 0);
        y += contribution.Average() / Strata;
    }
    EXPECT_NEAR(y / CIE_Y_integral, 1, 1e-3);
}

TEST(TerminateSecondary, TwiceIsOnce) {
    auto once = SampledWavelengths::SampleVisible(0.3f);
    once.TerminateSecondary();
    auto twice = once;
    twice.TerminateSecondary();
    EXPECT_EQ(once.PDF()[0], twice.PDF()[0]);
}

TEST(SampledSpectrum, ComponentFunctionsAgreeWithScalars) {
    const SampledSpectrum a(std::array<float, 4>{-2, 0, 0.25f, 9});
    const SampledSpectrum clamped = ClampZero(a), root = Sqrt(clamped);
    for (int i = 0; i < NSpectrumSamples; ++i) {
        EXPECT_EQ(clamped[i], std::max(0.f, a[i]));
        EXPECT_EQ(root[i], std::sqrt(clamped[i]));
    }
    EXPECT_EQ(a.MaxComponentValue(), 9);
    EXPECT_EQ(a.Average(), 7.25f / 4);
    EXPECT_TRUE(bool(a));
    EXPECT_FALSE(bool(SampledSpectrum(0)));
    EXPECT_FALSE((a / SampledSpectrum(0)).IsFinite());
}

}  // namespace
}  // namespace pbrt
