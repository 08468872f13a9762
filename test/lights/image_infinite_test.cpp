#include "pbrt/lights/image_infinite.h"

#include "lights/light_scene.h"
#include "support/chi_square.h"
#include "support/exr_parts.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

const RGBColorSpace &kSpace = RGBColorSpace::sRGB();

/// Grey sky with a ramp and a few bright texels.
Image Sky(int n) {
    Image image({n, n}, {"R", "G", "B"});
    std::mt19937 rng(3);
    std::uniform_real_distribution<float> u(0, 1);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const float v = 0.5f + float(x) / float(n) + (u(rng) > 0.95f ? 20 * u(rng) : 0);
            for (int c = 0; c < 3; ++c)
                image.Set({x, y}, c, v);
        }
    return image;
}

Transform Turned() {
    return *Transform::Rotate(50, {1, 2, -1});
}
Transform Squeezed() {
    return *Transform::Scale({1, 2, 0.5f}) * Turned();
}

ImageInfiniteLight Lit(const Image &image, const Transform &t = Turned()) {
    ImageInfiniteLight light = ImageInfiniteLight::FromImage(image, kSpace, 1, t);
    light.Preprocess(10);
    return light;
}
float Luminance(const SampledSpectrum &L, const Spectrum &illuminant,
                const SampledWavelengths &lambda) {
    return L[0] / illuminant.Sample(lambda)[0];
}

TEST(ImageInfiniteLight, PDFIntegratesToOneAndMatchesItsSamples) {
    for (const Transform &t : {Transform(), Turned(), Squeezed()}) {
        const ImageInfiniteLight light = Lit(Sky(16), t);
        // Midpoints of an equal-area grid; texel borders cut cells: about 1e-3.
        constexpr int n = 1024;
        double sum = 0;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                sum += double(light.PDF_Li(EqualAreaSquareToSphere(
                    Point2f{(float(x) + 0.5f) / n, (float(y) + 0.5f) / n})));
        EXPECT_NEAR(sum * 4 * double(Pi) / (n * n), 1, 3e-3);
        std::mt19937 rng(2);
        int agree = 0;
        for (int i = 0; i < 1000; ++i) {
            const auto s = light.SampleLi({}, UniformSquare(rng), kLambda);
            ASSERT_TRUE(s);
            EXPECT_NEAR(Length(s->wi), 1, 1e-5);
            if (std::abs(light.PDF_Li(s->wi) / s->pdf - 1) < 1e-4f) {
                ++agree;
                const SampledSpectrum Le = light.Le(s->wi, kLambda);
                for (int k = 0; k < NSpectrumSamples; ++k)
                    EXPECT_EQ(Le[k], s->L[k]);
            }
        }
        // Rounding moves points at a texel's border into its neighbour.
        EXPECT_GE(agree, 995);
    }
}

TEST(ImageInfiniteLight, SamplesFollowTheDensity) {
    for (const Transform &t : {Turned(), Squeezed()}) {
        const ImageInfiniteLight light = Lit(Sky(8), t);
        constexpr int bins = 16, fine = 64, samples = 200000;
        std::vector<double> counts(bins * bins), expected(bins * bins);
        std::mt19937 rng(4);
        for (int i = 0; i < samples; ++i) {
            const auto s = light.SampleLi({}, UniformSquare(rng), kLambda);
            const Point2f p = EqualAreaSphereToSquare(s->wi);
            counts[size_t(std::min(bins - 1, int(p.y * bins)) * bins +
                          std::min(bins - 1, int(p.x * bins)))] += 1;
        }
        for (int y = 0; y < bins * fine; ++y)
            for (int x = 0; x < bins * fine; ++x)
                expected[size_t(y / fine * bins + x / fine)] +=
                    double(light.PDF_Li(EqualAreaSquareToSphere(Point2f{
                        (float(x) + 0.5f) / (bins * fine), (float(y) + 0.5f) / (bins * fine)}))) *
                    4 * double(Pi) / (bins * fine * bins * fine) * samples;
        EXPECT_GT(TestCounts(counts, expected).pValue, Sidak(0.01, 2));
    }
}

/// Both ways to find light together, balance heuristic: what one leaves out the other has.
TEST(ImageInfiniteLight, IrradianceWithMISAgreesWithQuadrature) {
    const ImageInfiniteLight light = Lit(Sky(16));
    const Spectrum &white = light.sky->picture.Illuminant();
    const Normal3f n = Normalize(Vector3f{1, -2, 0.5f});
    constexpr int m = 1024;
    double want = 0;
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < m; ++x) {
            const Vector3f w =
                EqualAreaSquareToSphere(Point2f{(float(x) + 0.5f) / m, (float(y) + 0.5f) / m});
            want +=
                double(Luminance(light.Le(w, kLambda), white, kLambda) * std::max(0.f, Dot(n, w)));
        }
    want *= 4 * double(Pi) / (m * m);

    std::mt19937 rng(5);
    constexpr int samples = 100000;
    double sum = 0, squares = 0;
    const auto weighted = [&](Vector3f w) {
        const float cosine = Dot(n, w);
        if (!(cosine > 0)) return 0.0;
        return double(Luminance(light.Le(w, kLambda), white, kLambda) * cosine /
                      (light.PDF_Li(w) + cosine * InvPi));
    };
    for (int i = 0; i < samples; ++i) {
        const auto s = light.SampleLi({}, UniformSquare(rng), kLambda);
        // Cosine-distributed: a point of the sphere about the normal's tip.
        const Vector3f c = Normalize(n + UniformDirection(rng));
        const double estimate = weighted(s->wi) + weighted(c);
        sum += estimate, squares += estimate * estimate;
    }
    const double mean = sum / samples;
    const double sigma = std::sqrt((squares / samples - mean * mean) / samples);
    EXPECT_NEAR(mean, want, 4 * sigma + 2e-3 * want);  // 4 sigma: 6e-5 by chance
    EXPECT_LT(sigma, 0.01 * want);
}

TEST(ImageInfiniteLight, DimPartsAreLeftToTheBSDF) {
    Image image({4, 4}, {"R", "G", "B"});
    for (size_t i = 0; i < image.Data().size(); ++i)
        image.Data()[i] = i < 3 ? 100 : 1;  // one bright texel
    const ImageInfiniteLight light = Lit(image, Transform());
    EXPECT_GT(light.PDF_Li(EqualAreaSquareToSphere(Point2f{0.1f, 0.1f})), 0);
    EXPECT_EQ(light.PDF_Li(EqualAreaSquareToSphere(Point2f{0.6f, 0.6f})), 0);
}

TEST(ImageInfiniteLight, AConstantPictureIsSampledUniformly) {
    Image image({4, 4}, {"R", "G", "B"});
    std::fill(image.Data().begin(), image.Data().end(), 2.f);
    const ImageInfiniteLight light = Lit(image);
    EXPECT_FLOAT_EQ(light.PDF_Li(Vector3f{0, 0, 1}), 1 / (4 * Pi));
    EXPECT_NEAR(
        Luminance(light.Le({0.6f, 0, 0.8f}, kLambda), light.sky->picture.Illuminant(), kLambda), 2,
        1e-2);
    EXPECT_NEAR(light.Power(), 4 * Pi * Pi * 100 * 2, 40);
}

TEST(ImageInfiniteLight, StandsAsTurned) {
    // Light space +z (the picture's centre) shows in world +x.
    Image image({5, 5}, {"R", "G", "B"});
    for (int c = 0; c < 3; ++c)
        image.Set({2, 2}, c, 3);
    const ImageInfiniteLight light = Lit(image, *Transform::Rotate(90, {0, 1, 0}));
    EXPECT_GT(light.Le({1, 0, 0}, kLambda)[0], 0);
    EXPECT_EQ(light.Le({0, 0, 1}, kLambda)[0], 0);
    EXPECT_EQ(light.Le({-1, 0, 0}, kLambda)[0], 0);
}

/// Midpoints of what is looked up, n a texel's edge.
double SummedIlluminance(const Image &image, int n) {
    const ImageInfiniteLight light = Lit(image, Transform());
    const int m = n * image.Resolution().x;
    double sum = 0;
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < m; ++x) {
            const Vector3f w = EqualAreaSquareToSphere(
                Point2f{(float(x) + 0.5f) / float(m), (float(y) + 0.5f) / float(m)});
            if (w.z > 0)
                sum += double(w.z * Luminance(light.RadianceAt({(float(x) + 0.5f) / float(m),
                                                                (float(y) + 0.5f) / float(m)},
                                                               kLambda),
                                              light.sky->picture.Illuminant(), kLambda));
        }
    return sum * 4 * double(Pi) / (double(m) * m);
}

TEST(ImageInfiniteLight, IlluminanceOfAWhiteSkyIsPi) {
    for (const int n : {1, 2, 3, 4, 5, 7, 16, 33, 64, 256, 1000}) {
        Image image({n, n}, {"R", "G", "B"});
        std::fill(image.Data().begin(), image.Data().end(), 1.f);
        // Luminance of white: three roundings of a matrix in float, 1e-6.
        EXPECT_NEAR(ImageInfiniteLight::Illuminance(image, kSpace), double(Pi), 4e-6) << n;
    }
}

/// One texel after another, of which the horizon cuts some: together white, each as quadrature has
/// it.
TEST(ImageInfiniteLight, IlluminanceOfEachTexelIsItsIntegral) {
    for (const int n : {1, 2, 3, 4, 5}) {
        double sum = 0;
        for (int i = 0; i < n * n; ++i) {
            Image sun({n, n}, {"R", "G", "B"});
            for (int c = 0; c < 3; ++c)
                sun.Set({i % n, i / n}, c, 1);
            const double got = ImageInfiniteLight::Illuminance(sun, kSpace);
            sum += got;
            // The horizon, where the integrand is 0 but has a kink, runs through some of the 200 x
            // 200 cells: below 1e-4 of the whole; white as a sigmoid 1e-3.
            EXPECT_NEAR(got, SummedIlluminance(sun, 200), 1e-4 + 2e-3 * got) << i << " of " << n;
        }
        EXPECT_NEAR(sum, double(Pi), 1e-5);
    }
}

TEST(ImageInfiniteLight, WhatLiesBelowTheHorizonGivesNoIlluminanceAtAll) {
    for (const int n : {4, 6, 7, 100}) {
        Image image({n, n}, {"R", "G", "B"});
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                // The texel's point nearest to the square's centre.
                const auto nearest = [n](int i) {
                    return std::max({0, 2 * i - n, n - 2 * (i + 1)});
                };
                if (nearest(x) + nearest(y) >= n)
                    for (int c = 0; c < 3; ++c)
                        image.Set({x, y}, c, 1e6f);
            }
        EXPECT_EQ(ImageInfiniteLight::Illuminance(image, kSpace), 0) << n;
    }
}

using ImageInfiniteLightFiles = TempFolder;

TEST_F(ImageInfiniteLightFiles, OfOneAndFourTexelsMeetTheTargetIlluminance) {
    for (const int n : {1, 2}) {
        Image image({n, n}, {"R", "G", "B"});
        std::fill(image.Data().begin(), image.Data().end(), 0.5f);
        ASSERT_EQ(WriteImage(image, Path("sky.exr"), ExrPixels::Float), std::nullopt);
        const LightScene s(
            "LightSource \"infinite\" \"string filename\" \"sky.exr\" \"float illuminance\" 5",
            folder.string());
        const auto &light = std::get<ImageInfiniteLight>(s.Only());
        EXPECT_NEAR(
            Luminance(light.Le({0, 0, 1}, kLambda), light.sky->picture.Illuminant(), kLambda),
            5 / double(Pi), 2e-3);
    }
}

TEST_F(ImageInfiniteLightFiles, MeetTheTargetIlluminance) {
    ASSERT_EQ(WriteImage(Sky(32), Path("sky.exr"), ExrPixels::Float), std::nullopt);
    const LightScene s(
        "LightSource \"infinite\" \"string filename\" \"sky.exr\" "
        "\"float illuminance\" 40",
        folder.string());
    const auto &light = std::get<ImageInfiniteLight>(s.Only());
    constexpr int m = 512;
    double sum = 0;
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < m; ++x) {
            const Vector3f w =
                EqualAreaSquareToSphere(Point2f{(float(x) + 0.5f) / m, (float(y) + 0.5f) / m});
            if (w.z > 0)
                sum += double(w.z * Luminance(light.Le(w, kLambda), light.sky->picture.Illuminant(),
                                              kLambda));
        }
    EXPECT_NEAR(sum * 4 * double(Pi) / (m * m), 40, 0.4);
}

TEST_F(ImageInfiniteLightFiles, SayWhatOfThemIsNotRead) {
    WriteExrParts(Path("sky.exr"), {"left", "right"}, {2, 2});
    const LightScene s("LightSource \"infinite\" \"string filename\" \"sky.exr\"", folder.string());
    EXPECT_EQ(s.lights.size(), 1u);
    EXPECT_EQ(s.Messages(),
              "l.pbrt:2:24: " + Path("sky.exr") +
                  ": has 2 parts, of which only the first, \"left\", is read (others: "
                  "\"right\")\n");
}

TEST_F(ImageInfiniteLightFiles, AreCheckedForWhatTheyMustBe) {
    ASSERT_EQ(WriteImage(Image({4, 2}, {"R", "G", "B"}), Path("wide.exr")), std::nullopt);
    ASSERT_EQ(WriteImage(Image({4, 4}, {"Y"}), Path("grey.exr")), std::nullopt);
    Image broken({2, 2}, {"R", "G", "B"});
    broken.Set({1, 1}, 2, std::numeric_limits<float>::quiet_NaN());
    ASSERT_EQ(WriteImage(broken, Path("nan.exr")), std::nullopt);
    ASSERT_EQ(WriteImage(Sky(4), Path("sky.exr")), std::nullopt);
    const auto messages = [&](const std::string &params) {
        return LightScene("LightSource \"infinite\" " + params, folder.string()).Messages();
    };
    EXPECT_NE(messages("\"string filename\" \"wide.exr\"").find("is 4 x 2 pixels"),
              std::string::npos);
    EXPECT_NE(messages("\"string filename\" \"grey.exr\"").find("has no channel R"),
              std::string::npos);
    EXPECT_NE(messages("\"string filename\" \"nan.exr\"").find("not finite"), std::string::npos);
    EXPECT_NE(messages("\"string filename\" \"none.exr\"").find("none.exr"), std::string::npos);
    EXPECT_EQ(messages("\"string filename\" \"sky.exr\" \"rgb L\" [ 1 1 1 ]"),
              "l.pbrt:2:52: both \"L\" and \"filename\" are given; an infinite light takes one\n");
}

}  // namespace
}  // namespace pbrt::test
