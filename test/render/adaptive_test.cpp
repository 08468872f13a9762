// --target-error: fewer samples where a picture is clean, and how far its mean is off for that.

#include "pbrt/render/adaptive.h"

#include "pbrt/util/rng.h"
#include "render_text.h"

namespace pbrt {
namespace {

// A lamp over a diffuse floor, half of the picture black sky.
std::string Room(std::string_view sampler) {
    return "LookAt 0 2 -6  0 1 0  0 1 0\n"
           "Camera \"perspective\" \"float fov\" 50\n"
           "Film \"rgb\" \"integer xresolution\" 48 \"integer yresolution\" 48\n"
           "PixelFilter \"box\"\n"
           "Sampler \"" +
           std::string(sampler) +
           "\" \"integer pixelsamples\" 256\n"
           "WorldBegin\n"
           "Material \"diffuse\" \"rgb reflectance\" [ 0.7 0.5 0.3 ]\n"
           "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ]\n"
           "  \"point3 P\" [ -9 0 -9  -9 0 3  9 0 3  9 0 -9 ]\n"
           "Shape \"sphere\" \"float radius\" 0.7\n"
           "AttributeBegin\n"
           "AreaLightSource \"diffuse\" \"rgb L\" [ 6 6 6 ]\n"
           "Translate 1 3 -1\n"
           "Shape \"sphere\" \"float radius\" 0.4\n"
           "AttributeEnd\n";
}

struct Adapted {
    Image image;
    double samplesPerPixel = 0;
};

Adapted RenderTo(const std::string &text, float targetError, int seed, int nThreads = 0) {
    Diagnostics log;
    SceneDescription description;
    description.options.seed = seed;
    ParseString(text, "test.pbrt", ".", description, log);
    Overrides overrides;
    overrides.targetError = targetError;
    const auto task = MakeRenderTask(std::move(description), overrides, log);
    EXPECT_TRUE(task);
    if (!task) return {};
    test::Rendered r = test::RenderAll(*task, nThreads);
    return {std::move(r.image), r.stats.samplesPerPixel};
}

/// As RelativeSquaredError means it, of a picture against a much better one.
double TrueError(const Image &image, const Image &reference) {
    double sum = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
            for (int c = 0; c < 3; ++c) {
                const double r = reference.Get({x, y}, c);
                sum += Sqr(image.Get({x, y}, c) - r) / (Sqr(r) + 0.01);
            }
    return std::sqrt(sum / (48 * 48 * 3));
}

Image Converged() {
    Image mean = RenderTo(Room("independent"), 0, 100).image;
    constexpr int n = 32;
    for (int k = 1; k < n; ++k) {
        const Image more = RenderTo(Room("independent"), 0, 100 + k).image;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x)
                for (int c = 0; c < 3; ++c)
                    mean.Set({x, y}, c,
                             mean.Get({x, y}, c) * float(k) / float(k + 1) +
                                 more.Get({x, y}, c) / float(k + 1));
    }
    return mean;
}

TEST(RelativeSquaredError, IsThatOfTheMeanForIndependentSamples) {
    // 10 000 pixels of 32 samples of mean 2 and variance 1/3: variance of the mean 1/96, and the
    // estimate's own relative deviation sqrt(2 / 30 000) = 0.8 %. Five of them: 6e-7 of all runs.
    Rng rng(3);
    std::vector<Film::Pixel> half(10000), all;
    const auto add = [&](std::vector<Film::Pixel> *pixels) {
        for (Film::Pixel &pixel : *pixels)
            for (int k = 0; k < 16; ++k) {
                for (ExactSum &c : pixel.rgb)
                    c += 1 + 2 * rng.Uniform();
                pixel.weight += 1;
            }
    };
    add(&half);
    all = half;
    add(&all);
    EXPECT_NEAR(RelativeSquaredError(half, all), 1 / (96 * 4.01), 0.041 / (96 * 4.01));
}

TEST(TargetError, IsKeptWithFewerSamples) {
    const Image converged = Converged();
    const Adapted a = RenderTo(Room("independent"), 0.05f, 1);
    EXPECT_LT(a.samplesPerPixel, 128);
    EXPECT_LT(TrueError(a.image, converged), 0.05);
    // Doubling the samples more often than needed would show as a much smaller error.
    EXPECT_GT(TrueError(a.image, converged), 0.015);
    const Adapted z = RenderTo(Room("zsobol"), 0.05f, 1);
    EXPECT_LT(TrueError(z.image, converged), 0.05);
    EXPECT_LT(z.samplesPerPixel, 128);
}

TEST(TargetError, ReachedByNobodyTakesAllSamples) {
    const Adapted all = RenderTo(Room("independent"), 0, 1);
    const Adapted a = RenderTo(Room("independent"), 1e-6f, 1);
    EXPECT_EQ(all.samplesPerPixel, 256);
    EXPECT_GT(a.samplesPerPixel, 100);
    EXPECT_LT(TrueError(a.image, all.image), 1e-5);
}

TEST(TargetError, TheSameBitsForAnyNumberOfThreads) {
    EXPECT_EQ(RenderTo(Room("zsobol"), 0.05f, 1, 1).image.Data(),
              RenderTo(Room("zsobol"), 0.05f, 1, 2).image.Data());
}

TEST(TargetError, BiasIsBelowAThousandth) {
    // Stopping looks at what it averages. Means of 50 pictures against those of all samples.
    double sum = 0, sumSqr = 0;
    constexpr int n = 50;
    const double exact = test::Mean(Converged())[0];
    for (int k = 0; k < n; ++k) {
        const double ratio = test::Mean(RenderTo(Room("independent"), 0.1f, k).image)[0] / exact;
        sum += ratio - 1;
        sumSqr += Sqr(ratio - 1);
    }
    const double bias = sum / n, sigma = std::sqrt((sumSqr / n - Sqr(bias)) / (n - 1));
    EXPECT_LT(std::abs(bias), 1e-3 + 4 * sigma);
    EXPECT_LT(sigma, 1e-3) << "too noisy to tell";
}

}  // namespace
}  // namespace pbrt
