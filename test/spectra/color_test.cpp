#include "pbrt/spectra/color.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <thread>

namespace pbrt {
namespace {

/// rgb of `reflectance` under the space's illuminant.
RGB ColorUnderIlluminant(const RGBColorSpace &space, const Spectrum &reflectance) {
    const Spectrum &illuminant = space.Illuminant();
    XYZ c;
    for (int i = 0; i < DenseTable::Size; ++i) {
        const float lambda = LambdaMin + i, light = illuminant(lambda) * reflectance(lambda);
        c.X += light * spectra::X()(lambda);
        c.Y += light * spectra::Y()(lambda);
        c.Z += light * spectra::Z()(lambda);
    }
    const float norm = 1 / SpectrumToPhotometric(illuminant);
    return space.ToRGB({c.X * norm, c.Y * norm, c.Z * norm});
}

/// rgb of light, white being the illuminant itself.
RGB ColorOfLight(const RGBColorSpace &space, const Spectrum &light) {
    const XYZ c = SpectrumToXYZ(light);
    const float norm = 1 / SpectrumToXYZ(space.Illuminant()).Y;
    return space.ToRGB({c.X * norm, c.Y * norm, c.Z * norm});
}

void ExpectNear(const RGB &a, const RGB &b, float tolerance) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance) << b.r << " " << b.g << " " << b.b;
}

/// A space with the range of components that its sigmoids reach for every colour: saturated
/// light colours of the wide spaces lie beyond all reflectances.
struct Gamut {
    const char *name;
    float least, most;
};
std::ostream &operator<<(std::ostream &out, const Gamut &g) {
    return out << g.name;
}

class EveryColorSpace : public testing::TestWithParam<Gamut> {
  protected:
    const RGBColorSpace &space = *RGBColorSpace::Named(GetParam().name);
    std::mt19937 rng{7};
    RGB RandomColor() {
        std::uniform_real_distribution<float> component(GetParam().least, GetParam().most);
        return {component(rng), component(rng), component(rng)};
    }
};
INSTANTIATE_TEST_SUITE_P(Spaces, EveryColorSpace,
                         testing::Values(Gamut{"srgb", 0, 1}, Gamut{"rec2020", 0.1f, 0.8f},
                                         Gamut{"dci-p3", 0.05f, 0.95f},
                                         Gamut{"aces2065-1", 0.3f, 0.7f}));

TEST_P(EveryColorSpace, ConvertsToXYZAndBack) {
    for (int i = 0; i < 100; ++i) {
        const RGB c = RandomColor();
        ExpectNear(space.ToRGB(space.ToXYZ(c)), c, 1e-5f);
    }
}

TEST_P(EveryColorSpace, WhiteIsItsIlluminant) {
    ExpectNear(ColorOfLight(space, space.Illuminant()), {1, 1, 1}, 1e-5f);
    const XYZ white = space.ToXYZ({1, 1, 1});
    EXPECT_NEAR(white.Y, 1, 1e-6);
    const float sum = white.X + white.Y + white.Z;
    EXPECT_NEAR(space.Chromaticities()[3][0], white.X / sum, 1e-6);
    EXPECT_NEAR(space.Chromaticities()[3][1], white.Y / sum, 1e-6);
}

TEST_P(EveryColorSpace, PrimariesHaveTheirChromaticities) {
    for (int i = 0; i < 3; ++i) {
        RGB primary;
        primary[i] = 1;
        const XYZ c = space.ToXYZ(primary);
        const float sum = c.X + c.Y + c.Z;
        EXPECT_NEAR(c.X / sum, space.Chromaticities()[i][0], 1e-6);
        EXPECT_NEAR(c.Y / sum, space.Chromaticities()[i][1], 1e-6);
    }
}

TEST_P(EveryColorSpace, FittedSigmoidHasTheColor) {
    for (int i = 0; i < 100; ++i) {
        const RGB c = RandomColor();
        ExpectNear(ColorUnderIlluminant(space, space.AlbedoSpectrum(c)), c, 1e-4f);
        ExpectNear(ColorUnderIlluminant(space, space.UnboundedSpectrum(c * 7)), c * 7, 7e-4f);
        ExpectNear(ColorOfLight(space, space.IlluminantSpectrum(c * 7)), c * 7, 7e-4f);
    }
}

TEST_P(EveryColorSpace, TabulatedSigmoidHasTheColor) {
    for (int i = 0; i < 400; ++i) {
        const RGB c = RandomColor();
        ExpectNear(ColorUnderIlluminant(space, Spectrum(space.LookUpSigmoid(c))), c, 1e-2f);
    }
}

TEST_P(EveryColorSpace, DarkAndNearlyWhiteColorsKeepTheirHue) {
    for (int i = 0; i < 100; ++i) {
        const RGB c = RandomColor();
        const RGB dark = c * 0.01f, light{1 - dark.r, 1 - dark.g, 1 - dark.b};
        for (const RGB &near : {dark, light}) {
            ExpectNear(ColorUnderIlluminant(space, Spectrum(space.FitSigmoid(near))), near, 2e-5f);
            ExpectNear(ColorUnderIlluminant(space, Spectrum(space.LookUpSigmoid(near))), near,
                       5e-4f);
        }
    }
}

TEST_P(EveryColorSpace, GreysAreConstant) {
    for (const float grey : {0.f, 0.02f, 0.18f, 0.5f, 0.93f, 1.f}) {
        const RGB c{grey, grey, grey};
        const auto lambda = SampledWavelengths::SampleVisible(0.37f);
        for (int j = 0; j < NSpectrumSamples; ++j) {
            EXPECT_NEAR(space.FitSigmoid(c)(lambda[j]), grey, 1e-7f);
            EXPECT_NEAR(space.LookUpSigmoid(c)(lambda[j]), grey, 1e-7f);
            EXPECT_EQ(space.AlbedoSpectrum(c)(lambda[j]), grey);
            EXPECT_EQ(space.SampleAlbedo(c, lambda)[j], grey);
            EXPECT_EQ(space.SampleUnbounded(c * 20, lambda)[j], grey * 20);
            EXPECT_FLOAT_EQ(space.SampleIlluminant(c, lambda)[j],
                            grey * space.Illuminant()(lambda[j]));
        }
    }
    EXPECT_EQ(space.FitSigmoid({0, 0, 0})(500), 0);
    EXPECT_EQ(space.FitSigmoid({1, 1, 1})(500), 1);
}

TEST_P(EveryColorSpace, LookUpsAgreeWithTheSpectra) {
    for (int i = 0; i < 50; ++i) {
        const RGB c = RandomColor();
        const auto lambda = SampledWavelengths::SampleVisible(i / 50.f);
        const auto expectNear = [](SampledSpectrum a, SampledSpectrum b, float tolerance) {
            for (int j = 0; j < NSpectrumSamples; ++j)
                EXPECT_NEAR(a[j], b[j], tolerance);
        };
        // Two sigmoids of nearly one colour: looser than the colours.
        expectNear(space.SampleAlbedo(c, lambda), space.AlbedoSpectrum(c).Sample(lambda), 0.04f);
        expectNear(space.SampleUnbounded(c * 9, lambda),
                   space.UnboundedSpectrum(c * 9).Sample(lambda), 9 * 0.04f);
        expectNear(space.SampleIlluminant(c, lambda), space.IlluminantSpectrum(c).Sample(lambda),
                   0.04f * space.Illuminant().MaxValue());
    }
}

TEST_P(EveryColorSpace, CornersAndHostileValuesStayFinite) {
    const float values[] = {0, 1e-30f, 1e-6f, 0.5f, 1 - 1e-6f, 1, 2, -1, std::nanf("")};
    for (const float r : values)
        for (const float g : values)
            for (const float b : values)
                for (const RGBSigmoid &s :
                     {space.FitSigmoid({r, g, b}), space.LookUpSigmoid({r, g, b})})
                    for (const float lambda : {360.f, 550.f, 830.f}) {
                        EXPECT_GE(s(lambda), 0) << r << " " << g << " " << b;
                        EXPECT_LE(s(lambda), 1) << r << " " << g << " " << b;
                    }
}

TEST_P(EveryColorSpace, MaxValueBoundsTheSpectrum) {
    for (int i = 0; i < 30; ++i) {
        const RGB c = RandomColor();
        for (const Spectrum &s : {space.AlbedoSpectrum(c), space.UnboundedSpectrum(c * 10)}) {
            float max = 0;
            for (int k = 0; k <= 4700; ++k)
                max = std::max(max, s(LambdaMin + k * 0.1f));
            EXPECT_NEAR(s.MaxValue(), max, 1e-4f * max);
        }
    }
}

TEST(ColorSpace, PureColorsOfSRGBAreReached) {
    const RGBColorSpace &space = RGBColorSpace::sRGB();
    for (int i = 1; i < 7; ++i) {
        const RGB c{float(i & 1), float(i >> 1 & 1), float(i >> 2)};
        ExpectNear(ColorUnderIlluminant(space, space.AlbedoSpectrum(c)), c, 1e-4f);
        ExpectNear(ColorUnderIlluminant(space, Spectrum(space.LookUpSigmoid(c))), c, 5e-3f);
    }
}

TEST(ColorSpace, ColorsOutOfReachKeepTheirOrder) {
    for (const std::string_view name : RGBColorSpace::Names()) {
        const RGBColorSpace &space = *RGBColorSpace::Named(name);
        for (int i = 0; i < 3; ++i) {
            RGB primary;
            primary[i] = 1;
            const RGB c = ColorUnderIlluminant(space, space.AlbedoSpectrum(primary));
            for (int other : {(i + 1) % 3, (i + 2) % 3})
                EXPECT_GT(c[i], 2 * c[other]) << name;
        }
    }
}

TEST(ColorSpace, IsFoundByItsNameInAnyCase) {
    for (const std::string_view name : RGBColorSpace::Names())
        EXPECT_EQ(RGBColorSpace::Named(name)->Name(), name);
    EXPECT_EQ(RGBColorSpace::Named("sRGB"), &RGBColorSpace::sRGB());
    EXPECT_EQ(RGBColorSpace::Named("ACES2065-1"), RGBColorSpace::Named("aces2065-1"));
    EXPECT_EQ(RGBColorSpace::Named("cmyk"), nullptr);
    EXPECT_EQ(RGBColorSpace::Named(""), nullptr);
}

TEST(ColorSpace, SRGBHasTheStandardsMatrix) {
    const float standard[3][3] = {{3.2406f, -1.5372f, -0.4986f},  // IEC 61966-2-1
                                  {-0.9689f, 1.8758f, 0.0415f},
                                  {0.0557f, -0.2040f, 1.0570f}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(RGBColorSpace::sRGB().RGBFromXYZ()[i][j], standard[i][j], 1e-3f);
}

TEST(ColorSpace, TableIsTheSameForAnyNumberOfThreads) {
    const std::array<std::array<float, 2>, 4> xy = RGBColorSpace::sRGB().Chromaticities();
    const RGBColorSpace fresh("fresh", xy, RGBColorSpace::sRGB().Illuminant());
    std::array<RGBSigmoid, 4> found;
    std::vector<std::thread> threads;
    for (RGBSigmoid &f : found)
        threads.emplace_back([&] { f = fresh.LookUpSigmoid({0.3f, 0.6f, 0.1f}); });
    for (std::thread &t : threads)
        t.join();
    const RGBSigmoid expected = RGBColorSpace::sRGB().LookUpSigmoid({0.3f, 0.6f, 0.1f});
    for (const RGBSigmoid &f : found) {
        EXPECT_EQ(f.c0, expected.c0);
        EXPECT_EQ(f.c1, expected.c1);
        EXPECT_EQ(f.c2, expected.c2);
    }
}

TEST(WhiteBalance, TakesOneWhiteToTheOther) {
    const std::array<float, 2> d50{0.34567f, 0.35851f}, d65{0.31272f, 0.32903f};
    const Matrix3 m = WhiteBalance(d65, d50);
    const auto xyz = Mul(m, {d65[0] / d65[1], 1, (1 - d65[0] - d65[1]) / d65[1]});
    EXPECT_NEAR(xyz[0], d50[0] / d50[1], 1e-6);
    EXPECT_NEAR(xyz[1], 1, 1e-6);
    EXPECT_NEAR(xyz[2], (1 - d50[0] - d50[1]) / d50[1], 1e-6);
    // Bruce Lindbloom's published Bradford matrix D65 to D50.
    const float published[3][3] = {{1.0478112f, 0.0228866f, -0.0501270f},
                                   {0.0295424f, 0.9904844f, -0.0170491f},
                                   {-0.0092345f, 0.0150436f, 0.7521316f}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(m[i][j], published[i][j], 5e-4f);
}

TEST(WhiteBalance, OfOneWhiteIsTheIdentity) {
    const Matrix3 m = WhiteBalance({0.4f, 0.38f}, {0.4f, 0.38f});
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(m[i][j], i == j, 1e-6);
}

}  // namespace
}  // namespace pbrt
