#include "pbrt/textures/noise.h"

#include <cmath>

#include "pbrt/util/math.h"
#include "pbrt/util/rng.h"
#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

Point3f AnyPoint(Rng &rng, float size) {
    const auto one = [&] { return size * (2 * rng.Uniform() - 1); };
    return {one(), one(), one()};
}

TEST(Noise, HasTheValuesOfPerlinsProgram) {
    // Perlin 2002's reference program at (3.14, 42, 7).
    EXPECT_NEAR(Noise({3.14f, 42, 7}), 0.13691995878400012, 2e-6);
}

TEST(Noise, VanishesAtWholeCoordinatesAndRepeats) {
    Rng rng(1);
    for (int i = 0; i < 1000; ++i) {
        const Point3f p = AnyPoint(rng, 100);
        EXPECT_EQ(Noise({std::floor(p.x), std::floor(p.y), std::floor(p.z)}), 0);
        // The floats 256 further are coarser by 2^-16; the slope is below 3.
        EXPECT_NEAR(Noise(p), Noise({p.x + 256, p.y - 512, p.z}), 1e-4);
    }
    for (const float far : {0x1p24f, 1e30f, INFINITY, -INFINITY, NAN})
        EXPECT_TRUE(std::isfinite(Noise({far, 0.3f, far}))) << far;
}

TEST(Noise, IsSmoothAndOfMeanZero) {
    Rng rng(2);
    double sum = 0, ofAbsolute = 0;
    constexpr int kN = 100000;
    for (int i = 0; i < kN; ++i) {
        const Point3f p = AnyPoint(rng, 100);
        const float v = Noise(p);
        EXPECT_LE(std::abs(v), 1.04f);
        EXPECT_NEAR(Noise({p.x + 1e-3f, p.y, p.z}), v, 3e-3f);
        sum += v, ofAbsolute += std::abs(v);
    }
    // Cells are correlated within themselves alone: each of 2e6 cells has 1/20 points, so points
    // count as independent, of deviation 0.26. 4 sigma.
    EXPECT_NEAR(sum / kN, 0, 4 * 0.26 / std::sqrt(kN));
    EXPECT_NEAR(ofAbsolute / kN, 0.2, 0.02);  // Turbulence's constant
}

TEST(FBm, IsASumOfOctaves) {
    Rng rng(3);
    for (int i = 0; i < 100; ++i) {
        const Point3f p = AnyPoint(rng, 5);
        float sum = 0, absolutes = 0;
        for (int octave = 0; octave < 3; ++octave) {
            const float f = std::pow(1.99f, float(octave)), height = std::pow(0.6f, float(octave));
            sum += height * Noise({f * p.x, f * p.y, f * p.z});
            absolutes += height * std::abs(Noise({f * p.x, f * p.y, f * p.z}));
        }
        EXPECT_NEAR(FBm(p, {}, {}, 0.6f, 3), sum, 1e-5f);
        // The mean of the octave after the last, see noise.h.
        EXPECT_NEAR(Turbulence(p, {}, {}, 0.6f, 3), absolutes + 0.2f * std::pow(0.6f, 3.f), 1e-5f);
    }
}

TEST(FBm, LosesOctavesSmoothlyWithThePixelsSteps) {
    const Point3f p{0.3f, 0.7f, 0.2f};
    // Half a wave of the first octave a pixel: nothing but means.
    EXPECT_EQ(FBm(p, {0.5f, 0, 0}, {}, 0.5f, 8), 0);
    EXPECT_NEAR(Turbulence(p, {}, {0, 0.5f, 0}, 0.5f, 2), 0.2f * (1 + 1 + 0.5f), 1e-6f);
    // Steps a thousandth of an octave apart; the steepest cubic has the slope 1.5 / 0.4.
    for (float octave = 0; octave < 8; octave += 1e-3f) {
        const auto at = [&](float o) { return FBm(p, {0, 0, 0.5f * std::exp2(-o)}, {}, 0.5f, 8); };
        EXPECT_NEAR(at(octave), at(octave + 1e-3f), 1.5e-3f / 0.4f * 1.04f + 1e-5f);
    }
}

TEST(NoiseTextures, LieInTextureSpace) {
    const TextureScene scene(R"(
        Translate 1 2 3 Scale 2 2 2
        Texture "f" "float" "fbm" "integer octaves" 3
        Texture "w" "float" "wrinkled" "float roughness" 0.25)");
    Rng rng(4);
    for (int i = 0; i < 100; ++i) {
        const Point3f p = AnyPoint(rng, 4);
        TextureEvalContext ctx = AtPoint({1 + 2 * p.x, 2 + 2 * p.y, 3 + 2 * p.z});
        ctx.dpdx = {0.25f, 0, 0};
        const Vector3f half{0.125f, 0, 0};
        EXPECT_NEAR(scene.Float("f").Evaluate(ctx), FBm(p, half, {}, 0.5f, 3), 1e-5f);
        EXPECT_NEAR(scene.Float("w").Evaluate(ctx), Turbulence(p, half, {}, 0.25f, 8), 1e-5f);
    }
    EXPECT_EQ(
        TextureScene(R"(Texture "s" "spectrum" "fbm")").Messages(),
        "t.pbrt:2:1: texture class \"fbm\" makes floats only; make it a float texture and use "
        "that as \"texture scale\" of a spectrum texture of class \"scale\"\n");
}

TEST(Dots, AreRoundInAThirdOfTheCells) {
    const TextureScene scene(R"(
        Texture "d" "float" "dots" "float uscale" 2 "float inside" 5 "float outside" 3)");
    const auto at = [&](float s, float t) {
        return scene.Float("d").Evaluate(AtUV(s / 2, t)) == 5;
    };
    int dots = 0;
    constexpr int kCells = 25, kSteps = 50;
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j) {
            // Area and centroid of what is inside in the cell.
            int n = 0;
            double x = 0, y = 0, farthest = 0;
            for (const bool measures : {false, true})
                for (int k = 0; k < kSteps * kSteps; ++k) {
                    const double u = (k % kSteps + 0.5) / kSteps - 0.5;
                    const double v = (k / kSteps + 0.5) / kSteps - 0.5;
                    if (!at(float(i + u), float(j + v))) continue;
                    if (measures)
                        farthest = std::max(farthest, std::hypot(u - x / n, v - y / n));
                    else
                        ++n, x += u, y += v;
                }
            if (n == 0) continue;
            ++dots;
            EXPECT_NEAR(double(n) / (kSteps * kSteps), M_PI * 0.35 * 0.35, 0.02);
            EXPECT_NEAR(farthest, 0.35, 0.03);
        }
    // Noise in the middle between lattice points is as often above 0 as below, and often 0: there
    // it is a sum of few multiples of 1/16.
    EXPECT_GT(dots, kCells * kCells * 0.3);
    EXPECT_LT(dots, kCells * kCells * 0.45);
}

TEST(DirectionMix, GoesByTheCosine) {
    const TextureScene scene(R"(
        Scale 1 3 1 Rotate 90 1 0 0
        Texture "m" "float" "directionmix" "float tex1" 2 "float tex2" 10 "vector3 dir" [ 0 0 -7 ])");
    // The texture's z lies along y.
    for (const float angle : {0.f, 30.f, 60.f, 90.f, 150.f, 180.f}) {
        TextureEvalContext ctx;
        ctx.n = {std::sin(Radians(angle)), std::cos(Radians(angle)), 0};
        const float c = std::abs(std::cos(Radians(angle)));
        EXPECT_NEAR(scene.Float("m").Evaluate(ctx), 2 * c + 10 * (1 - c), 1e-5f);
    }
    EXPECT_EQ(
        TextureScene(R"(Texture "m" "float" "directionmix" "vector3 dir" [ 0 0 0 ])").Messages(),
        "t.pbrt:2:36: \"dir\" has no length to speak of\n");
}

}  // namespace
}  // namespace pbrt::test
