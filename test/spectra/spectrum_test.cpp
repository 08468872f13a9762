#include "pbrt/spectra/spectrum.h"

#include <gtest/gtest.h>

#include <random>

namespace pbrt {
namespace {

constexpr RGBSigmoid kHill{-2e-4f, 0.22f, -60};

std::shared_ptr<const DenseTable> Ramp() {
    auto table = std::make_shared<DenseTable>();
    for (int i = 0; i < DenseTable::Size; ++i)
        table->values.push_back(1 + 0.01f * i);
    return table;
}

/// Every kind once.
std::vector<Spectrum> Kinds() {
    const std::array<float, 4> lambda{410.3f, 502, 502.5f, 780}, values{1, 4, 2, 3};
    return {Spectrum(0.7f),
            Spectrum(kHill),
            Spectrum(kHill, 3.5f),
            Spectrum(kHill, 2, Ramp()),
            Spectrum::Dense(Ramp(), 0.5f),
            Spectrum::PiecewiseLinear(lambda, values),
            Spectrum::Blackbody(4000),
            Spectrum::Daylight(6500)};
}

TEST(Spectrum, SampleIsTheValueAtEachWavelength) {
    for (const Spectrum &s : Kinds())
        for (int i = 0; i < 400; ++i) {
            const auto w = SampledWavelengths::SampleVisible(i / 400.f);
            const SampledSpectrum sampled = s.Sample(w);
            for (int j = 0; j < NSpectrumSamples; ++j)
                EXPECT_FLOAT_EQ(sampled[j], s(w[j]));
        }
}

TEST(Spectrum, MaxValueIsReachedAndNotExceeded) {
    for (const Spectrum &s : Kinds()) {
        float max = 0;
        for (int i = 0; i <= 47000; ++i)
            max = std::max(max, s(LambdaMin + i * 0.01f));
        EXPECT_NEAR(s.MaxValue(), max, 1e-4f * max);
    }
}

TEST(Spectrum, ScaledMultiplies) {
    for (const Spectrum &s : Kinds())
        for (const float lambda : {365.f, 512.25f, 700.f})
            EXPECT_FLOAT_EQ(s.Scaled(3)(lambda), 3 * s(lambda));
}

TEST(Spectrum, DenselyAgreesAtWholeNanometres) {
    for (const Spectrum &s : Kinds()) {
        const Spectrum dense = s.Densely();
        for (int lambda = 360; lambda <= 830; ++lambda)
            EXPECT_FLOAT_EQ(dense(lambda), s(lambda));
    }
}

TEST(Spectrum, DenselyAgreesEverywhereWithKnotsAtWholeNanometres) {
    const std::array<float, 4> lambda{360, 401, 700, 830}, values{1, 5, 2, 0};
    const Spectrum exact = Spectrum::PiecewiseLinear(lambda, values), dense = exact.Densely();
    for (float at = 360; at <= 830; at += 0.37f)
        EXPECT_NEAR(dense(at), exact(at), 2e-5f);
}

TEST(Spectrum, TablesAreLinearBetweenAndZeroOutside) {
    const Spectrum dense = Spectrum::Dense(Ramp());
    EXPECT_FLOAT_EQ(dense(400.25f), 1.4025f);
    EXPECT_FLOAT_EQ(dense(360), 1);
    EXPECT_FLOAT_EQ(dense(830), 5.7f);
    EXPECT_EQ(dense(359.9f), 0);
    EXPECT_EQ(dense(830.1f), 0);
    const std::array<float, 3> lambda{500, 510, 600}, values{1, 2, 4};
    const Spectrum points = Spectrum::PiecewiseLinear(lambda, values);
    EXPECT_FLOAT_EQ(points(500), 1);
    EXPECT_FLOAT_EQ(points(507.5f), 1.75f);
    EXPECT_FLOAT_EQ(points(510), 2);
    EXPECT_FLOAT_EQ(points(600), 4);
    EXPECT_EQ(points(499.99f), 0);
    EXPECT_EQ(points(600.01f), 0);
}

TEST(Spectrum, OnePointIsASpike) {
    const std::array<float, 1> lambda{550}, values{3};
    const Spectrum s = Spectrum::PiecewiseLinear(lambda, values);
    EXPECT_EQ(s(550), 3);
    EXPECT_EQ(s(550.1f), 0);
    EXPECT_EQ(s(549.9f), 0);
}

TEST(Sigmoid, StaysInUnitRange) {
    std::mt19937 rng(1);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 1000; ++i) {
        const float size = std::pow(10.f, 4 * normal(rng));
        const RGBSigmoid s{1e-5f * size * normal(rng), 1e-2f * size * normal(rng),
                           size * normal(rng)};
        for (float lambda = 360; lambda <= 830; lambda += 23.5f) {
            EXPECT_GE(s(lambda), 0);
            EXPECT_LE(s(lambda), 1);
        }
    }
}

TEST(Sigmoid, InfiniteConstantIsExactlyBlackOrWhite) {
    const RGBSigmoid white{0, 0, Infinity}, black{0, 0, -Infinity};
    for (float lambda = 360; lambda <= 830; ++lambda) {
        EXPECT_EQ(white(lambda), 1);
        EXPECT_EQ(black(lambda), 0);
    }
    EXPECT_EQ(white.MaxValue(), 1);
    EXPECT_EQ(black.MaxValue(), 0);
}

TEST(Sigmoid, FollowsItsFormula) {
    for (double lambda = 360; lambda <= 830; lambda += 7) {
        const double x = (double(kHill.c0) * lambda + double(kHill.c1)) * lambda + double(kHill.c2);
        EXPECT_NEAR(kHill(float(lambda)), 0.5 + x / (2 * std::sqrt(1 + x * x)), 2e-5);
    }
}

TEST(Blackbody, FollowsPlanck) {
    // Evaluated separately with h, c, k of the SI of 2019.
    EXPECT_NEAR(BlackbodyRadiance(483, 6000) / 3.184797e13, 1, 1e-6);
    EXPECT_NEAR(BlackbodyRadiance(600, 6000) / 2.867639e13, 1, 1e-6);
    EXPECT_NEAR(BlackbodyRadiance(500, 3700) / 1.598367e12, 1, 1e-6);
    EXPECT_NEAR(BlackbodyRadiance(600, 4500) / 7.464706e12, 1, 1e-6);
}

TEST(Blackbody, PeaksWhereWienSays) {
    for (const double kelvin : {2700., 3000., 4500., 5600., 6000.}) {
        const double peak = 2.897771955e6 / kelvin;
        const double most = BlackbodyRadiance(peak, kelvin);
        EXPECT_GT(most, BlackbodyRadiance(0.999 * peak, kelvin));
        EXPECT_GT(most, BlackbodyRadiance(1.001 * peak, kelvin));
    }
    for (const float kelvin : {4500.f, 6000.f, 7500.f})  // peak in 360-830 nm
        EXPECT_NEAR(Spectrum::Blackbody(kelvin).MaxValue(), 1, 1e-4);
    EXPECT_LT(Spectrum::Blackbody(2700).MaxValue(), 1);  // beyond the red
}

TEST(Blackbody, SpectrumHasPlancksShape) {
    for (const float kelvin : {500.f, 2700.f, 6500.f, 20000.f}) {
        const Spectrum s = Spectrum::Blackbody(kelvin);
        const double peak = BlackbodyRadiance(2.897771955e6 / kelvin, kelvin);
        for (float lambda = 360; lambda <= 830; lambda += 9.3f) {
            const double expected = BlackbodyRadiance(lambda, kelvin) / peak;
            // 1 nm steps: worst at 500 K, where radiance grows 20 % a nm in the blue.
            EXPECT_NEAR(s(lambda), expected, 8e-3 * expected);
        }
    }
}

TEST(XYZ, OfEqualEnergyIsOne) {
    const XYZ c = SpectrumToXYZ(Spectrum(1.f));
    EXPECT_NEAR(c.X, 1, 5e-4);
    EXPECT_NEAR(c.Y, 1, 1e-6);
    EXPECT_NEAR(c.Z, 1, 5e-4);
    const XYZ half = SpectrumToXYZ(Spectrum(0.5f));
    EXPECT_NEAR(half.Y, 0.5f, 1e-6);
}

/// Integral of a(lambda) b(lambda) over 360-830 nm (1 nm sums).
float InnerProduct(const Spectrum &a, const Spectrum &b) {
    double sum = 0;
    for (int i = 0; i <= int(LambdaMax - LambdaMin); ++i)
        sum += double(a(LambdaMin + i)) * b(LambdaMin + i);
    return float(sum);
}

TEST(XYZ, PhotometricIntegralIsInnerProductWithY) {
    for (const Spectrum &s : Kinds()) {
        const float expected = InnerProduct(s, spectra::Y());
        EXPECT_NEAR(SpectrumToPhotometric(s), expected, 1e-6f * expected);
        EXPECT_NEAR(SpectrumToXYZ(s).Y * CIE_Y_integral, expected, 1e-6f * expected);
    }
    EXPECT_NEAR(SpectrumToPhotometric(Spectrum(1.f)), CIE_Y_integral, 1e-4);
}

TEST(XYZ, MatchingFunctionsAreTheObservers) {
    EXPECT_EQ(spectra::Y()(555), 1);  // by definition of the lumen
    // CIE 015:2018.
    EXPECT_NEAR(spectra::X()(600), 1.0622f, 5e-5);
    EXPECT_NEAR(spectra::Y()(600), 0.6310f, 5e-5);
    EXPECT_NEAR(spectra::Z()(445), 1.7826f, 5e-5);
}

}  // namespace
}  // namespace pbrt
