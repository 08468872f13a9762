#include <random>

#include "imgtool/tool_test.h"
#include "pbrt/imgtool/tile_scores.h"

namespace pbrt::imgtool {
namespace {

class Diffing : public ToolTest {
  protected:
    Outcome DiffOf(const Image &image, const Image &reference,
                   std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"diff", Save("a.exr", image), "--reference",
                                         Save("reference.exr", reference)});
        return Do(options);
    }
};

TEST_F(Diffing, EqualPicturesAreSilent) {
    const Outcome outcome =
        DiffOf(Picture({1, 1}, kRGB, {1, 2, 3}), Picture({1, 1}, kRGB, {1, 2, 3}));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Diffing, DifferenceIsReportedInEachMetric) {
    const Image image = Picture({1, 1}, kRGB, {1, 2, 4}),
                reference = Picture({1, 1}, kRGB, {1, 2, 1});
    const std::string averages =
        Path("a.exr") + ": average 2.33333\n" + Path("reference.exr") + ": average 1.33333\n";
    Outcome outcome = DiffOf(image, reference);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.out, averages + "delta +75.0000 %, MSE 3\n");
    EXPECT_EQ(DiffOf(image, reference, {"--metric", "MAE"}).out,
              averages + "delta +75.0000 %, MAE 1\n");
    // 9 / 1.01^2 / 3
    EXPECT_EQ(DiffOf(image, reference, {"--metric", "mrse"}).out,
              averages + "delta +75.0000 %, MRSE 2.94089\n");
    EXPECT_EQ(
        DiffOf(image, reference, {"--metric", "PSNR"}).err,
        "imgtool: unknown metric \"PSNR\"; there are \"MSE\", \"MAE\", \"MRSE\" or \"FLIP\"\n");
}

TEST_F(Diffing, ToleranceChannelsAndCrop) {
    const Image image = Picture({2, 1}, kRGB, {1, 2, 4, 0, 0, 0});
    const Image reference = Picture({2, 1}, kRGB, {1, 2, 1, 0, 0, 0});
    EXPECT_EQ(DiffOf(image, reference, {"--difftol", "1.5"}).exitCode, 0);
    EXPECT_EQ(DiffOf(image, reference, {"--difftol", "1.49"}).exitCode, 1);
    EXPECT_EQ(DiffOf(image, reference, {"--channels", "R,G"}).exitCode, 0);
    EXPECT_EQ(DiffOf(image, reference, {"--crop", "1,2,0,1"}).exitCode, 0);
}

TEST_F(Diffing, NotANumberIsADifference) {
    const Image image = Picture({1, 1}, kRGB, {1, NAN, 3});
    EXPECT_EQ(DiffOf(image, image).exitCode, 1);
    EXPECT_EQ(DiffOf(image, image, {"--difftol", "1e30"}).exitCode, 1);
}

TEST_F(Diffing, WhatCannotBeComparedSaysWhy) {
    const Image image({2, 2}, kRGB);
    EXPECT_EQ(DiffOf(image, Image({2, 1}, kRGB)).err,
              "imgtool: the pictures differ in size: 2 x 2 and 2 x 1 pixels\n");
    EXPECT_EQ(DiffOf(image, Image({2, 2}, {"Y"})).err,
              "imgtool: the pictures differ in channels: R, G, B and Y\n");
    Image wide = image;
    wide.metadata.chromaticities = {
        {{0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.329f}}};
    EXPECT_EQ(DiffOf(image, wide).err,
              "imgtool: the pictures differ in color space; \"imgtool "
              "convert --colorspace\" helps\n");
}

TEST_F(Diffing, OutfileHoldsTheErrorOfEachValue) {
    const Image image = Picture({1, 1}, kRGB, {1, 2, 4}),
                reference = Picture({1, 1}, kRGB, {1, 2, 1});
    DiffOf(image, reference, {"--outfile", Path("error.exr")});
    EXPECT_EQ(Load(Path("error.exr")).Data(), (std::vector<float>{0, 0, 9}));
}

/// Mean 1 with normal noise of this variance (which grows with x), times 1 + bias in the tile at
/// (20, 10).
Image Noisy(unsigned seed, float varianceScale, float bias = 0) {
    Image image({60, 40}, {"R", "G", "B"});
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            for (int c = 0; c < 3; ++c) {
                const bool inTile = x / 10 == 2 && y / 10 == 1;
                image.Set(
                    {x, y}, c,
                    1 + (inTile ? bias : 0) + std::sqrt(varianceScale * (1 + x)) * normal(random));
            }
    return image;
}

Image VarianceOfNoise(float varianceScale) {
    Image image({60, 40}, {"R", "G", "B"});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            for (int c = 0; c < 3; ++c)
                image.Set({x, y}, c, varianceScale * (1 + x));
    return image;
}

TEST_F(Diffing, TilesPassNoiseAndFailBias) {
    // The reference has 16 times the samples; the chance that pure noise fails is 0.01 per seed.
    Image reference = Noisy(1, 1e-4f / 16), image = Noisy(2, 1e-4f);
    reference.metadata.samplesPerPixel = 1024;
    image.metadata.samplesPerPixel = 64;
    const std::string variance = Save("variance.exr", VarianceOfNoise(1e-4f / 16));
    const Outcome good = DiffOf(image, reference, {"--variance", variance});
    EXPECT_EQ(good.exitCode, 0) << good.out;
    EXPECT_NE(good.out.find("0 of 72 z-scores (10 x 10 tiles, 3 channels) beyond +-3.8"),
              std::string::npos)
        << good.out;

    Image biased = Noisy(3, 1e-4f, 0.05f);
    biased.metadata.samplesPerPixel = 64;
    const Outcome bad = DiffOf(biased, reference, {"--variance", variance});
    EXPECT_EQ(bad.exitCode, 1);
    EXPECT_NE(bad.out.find("3 of 72 z-scores"), std::string::npos) << bad.out;
    EXPECT_NE(bad.out.find("in the tile at (20, 10)"), std::string::npos) << bad.out;
}

TEST(TileScores, ScoresOfPureNoiseAreStandardNormal) {
    // rms z of 72 scores: 1 +- 0.083 (one standard deviation); mean z: 0 +- 0.118. Averages of 50
    // seeds have a seventh of that; bounds at 4 standard deviations (6e-5).
    double meanZ = 0, squareZ = 0;
    int failures = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const TileScores test =
            CompareTiles(Noisy(2 * seed + 10, 1e-4f), Noisy(2 * seed + 11, 2.5e-5f),
                         VarianceOfNoise(2.5e-5f), 4, 10, 0.01);
        meanZ += test.meanZ / 50;
        squareZ += test.rmsZ * test.rmsZ / 50;
        failures += test.beyond;
    }
    EXPECT_NEAR(meanZ, 0, 4 * 0.118 / std::sqrt(50.));
    EXPECT_NEAR(squareZ, 1, 4 * std::sqrt(2. / (72 * 50)));
    EXPECT_LE(failures, 4);  // 0.5 expected; more than 4 in 2e-4 of all cases
}

TEST(TileScores, PixelsWithoutNoiseMayDifferByRounding) {
    Image a({10, 10}, {"Y"}), b = a, variance = a;
    for (float &v : a.Data())
        v = 1;
    for (float &v : b.Data())
        v = 1.0002f;
    EXPECT_EQ(CompareTiles(a, b, variance, 1, 10, 0.01).beyond, 1);
    a.metadata.storedAs = "half";  // steps of 0.001
    EXPECT_EQ(CompareTiles(a, a, variance, 1, 10, 0.01).beyond, 0);
    for (float &v : b.Data())
        v = 1.00005f;
    EXPECT_EQ(CompareTiles(a, b, variance, 1, 10, 0.01).beyond, 0);
}

TEST(TileScores, SidakBoundIsTheTwoSidedNormalQuantile) {
    EXPECT_NEAR(SidakBound(1, 0.05), 1.959964, 1e-6);
    EXPECT_NEAR(SidakBound(1, 0.01), 2.575829, 1e-6);
    // 1 - 0.99^(1/100) = 1.00498e-4 two-sided
    EXPECT_NEAR(SidakBound(100, 0.01), 3.889, 1e-3);
    EXPECT_LT(SidakBound(100, 0.01), SidakBound(1000, 0.01));
}

}  // namespace
}  // namespace pbrt::imgtool
