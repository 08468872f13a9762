// Films spectral and gbuffer: what their further channels hold.

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// `world` seen along z by a camera of 2 x 2 units and 16 x 16 pixels.
std::string Scene(const std::string &film, const std::string &world, int spp) {
    return fmt::format(
        "LookAt 0 0 -5  0 0 0  0 1 0\n"
        "Camera \"orthographic\" \"float screenwindow\" [ -1 1 -1 1 ]\n"
        "Film {} \"integer xresolution\" 16 \"integer yresolution\" 16\n"
        "Sampler \"zsobol\" \"integer pixelsamples\" {}\nIntegrator \"path\"\nWorldBegin\n{}",
        film, spp, world);
}

std::string Surroundings(const std::string &L) {
    return "LightSource \"infinite\" " + L + "\n";
}

std::string Spectral(int nBuckets, float least, float most) {
    return fmt::format(
        "\"spectral\" \"integer nbuckets\" {} \"float lambdamin\" {} \"float lambdamax\" {}",
        nBuckets, least, most);
}

/// Mean of a channel over the picture.
double ChannelMean(const Image &image, int channel) {
    double sum = 0;
    const Point2i n = image.Resolution();
    for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x)
            sum += image.Get({x, y}, channel);
    return sum / (double(n.x) * n.y);
}

TEST(SpectralFilm, ALineComesOutInItsBucket) {
    const std::string line = Surroundings("\"spectrum L\" [ 544 0 545 1 549 1 550 0 ]");
    for (int n : {1, 2, 7, 16, 47, 100}) {
        const Image image = RenderText(Scene(Spectral(n, 360, 830), line, 64));
        ASSERT_EQ(image.NChannels(), 3 + n);
        for (int b = 0; b < n; ++b) {
            const double first = 360 + 470.0 * b / n, last = 360 + 470.0 * (b + 1) / n;
            const double mean = ChannelMean(image, 3 + b);
            if (last <= 544 || first >= 550) {
                EXPECT_EQ(mean, 0) << b << " of " << n;
            } else if (std::min(last, 550.0) - std::max(first, 544.0) > 1) {
                EXPECT_GT(mean, 0) << b << " of " << n;
            }
        }
    }
}

TEST(SpectralFilm, WhiteIsFlatAndOne) {
    const std::string white = Surroundings("\"spectrum L\" [ 300 1 900 1 ]");
    for (const auto &[n, least, most] :
         {std::tuple(1, 360.f, 830.f), std::tuple(16, 360.f, 830.f), std::tuple(9, 412.f, 655.f)}) {
        const Image image = RenderText(Scene(Spectral(n, least, most), white, 16));
        for (int b = 0; b < n; ++b)
            EXPECT_NEAR(ChannelMean(image, 3 + b), 1, 1e-4) << b << " of " << n;
    }
}

TEST(SpectralFilm, ChannelsAreNamedAfterTheMiddles) {
    const Image image =
        RenderText(Scene(Spectral(2, 400, 701), Surroundings("\"rgb L\" [ 1 1 1 ]"), 1));
    EXPECT_EQ(image.ChannelNames(),
              (std::vector<std::string>{"R", "G", "B", "S0.475,250nm", "S0.625,750nm"}));
}

TEST(SpectralFilm, BucketsAddUpToTheRGBFilm) {
    const std::string world = Surroundings("\"rgb L\" [ .9 .6 .3 ]") +
                              "Material \"diffuse\" \"rgb reflectance\" [ .2 .5 .7 ]\n"
                              "Shape \"sphere\" \"float radius\" .8\n";
    constexpr int kBuckets = 94;  // of 5 nm
    const Image spectral = RenderText(Scene(Spectral(kBuckets, 360, 830), world, 256)),
                rgb = RenderText(Scene("\"rgb\"", world, 256));
    double X = 0, Y = 0, Z = 0;
    for (int b = 0; b < kBuckets; ++b) {
        const double S = ChannelMean(spectral, 3 + b) / CIE_Y_integral;
        for (int i = 0; i < 5; ++i) {
            const float lambda = 360.5f + float(5 * b + i);
            X += S * spectra::X()(lambda), Y += S * spectra::Y()(lambda);
            Z += S * spectra::Z()(lambda);
        }
    }
    for (const Image *image : {&rgb, &spectral}) {
        const auto mean = Mean(*image);
        const XYZ xyz =
            RGBColorSpace::sRGB().ToXYZ({float(mean[0]), float(mean[1]), float(mean[2])});
        // 65536 paths: standard errors of some 0.1 %; 5 of them.
        EXPECT_NEAR(xyz.X / X, 1, 0.005);
        EXPECT_NEAR(xyz.Y / Y, 1, 0.005);
        EXPECT_NEAR(xyz.Z / Z, 1, 0.005);
    }
}

TEST(SpectralFilm, EndedWavelengthsLeaveTheirWeightToTheOneThatIsLeft) {
    const SpectralFilm buckets = [] {
        Diagnostics log;
        ParamDict params(ParsedParameters{}, {}, "film", &RGBColorSpace::sRGB(), &log);
        return SpectralFilm::Create(params);
    }();
    SpectralFilm::Sums sums = buckets.NewSums();
    // Every bucket sees all wavelengths of some paths, and 1 or 2 as the one of others.
    constexpr int kPaths = 16000;
    for (int i = 0; i < kPaths; ++i) {
        SampledWavelengths lambda = buckets.SampleWavelengths((float(i) + 0.5f) / kPaths);
        if (i % 2) lambda.TerminateSecondary();
        buckets.Add(&sums, {{}, SampledSpectrum(i % 2 ? 2.f : 1.f), lambda, 1, nullptr, {}});
    }
    std::vector<float> values(16);
    buckets.Write(sums, values.data());
    // Half of the paths have 1, the other half 2.
    for (float v : values)
        EXPECT_NEAR(v, 1.5, 2e-3);
}

std::string GBuffer(const std::string &space) {
    return "\"gbuffer\" \"string coordinatesystem\" \"" + space + "\"";
}

float At(const Image &image, const char *channel, Point2i p = {8, 8}) {
    const int c = image.ChannelIndex(channel);
    EXPECT_GE(c, 0) << channel;
    return image.Get(p, c);
}

/// A grey plane at z = 2 turned by 45 degrees about y: z = 2 + x in the world, 7 + x for the
/// camera.
std::string Slope() {
    return Surroundings("\"spectrum L\" [ 300 1 900 1 ]") +
           "Translate 0 0 2 Rotate -45 0 1 0\n"
           "Material \"diffuse\" \"rgb reflectance\" [ .3 .3 .3 ]\n"
           "Shape \"bilinearmesh\" \"point3 P\" [ -9 -9 0  9 -9 0  -9 9 0  9 9 0 ]\n";
}

TEST(GBufferFilm, HoldsPositionsAndNormals) {
    for (const char *space : {"camera", "world"}) {
        const Image image = RenderText(Scene(GBuffer(space), Slope(), 256));
        const float z = space == std::string("camera") ? 7 : 2;
        for (const Point2i &p : {Point2i{2, 3}, Point2i{8, 8}, Point2i{14, 9}}) {
            // Means over the pixel, whose filter is symmetric; noise of 256 samples.
            const float x = (float(p.x) + 0.5f) / 8 - 1, y = 1 - (float(p.y) + 0.5f) / 8;
            const float worldX = At(image, "P.X", p);
            EXPECT_NEAR(std::abs(worldX), std::abs(x), 0.01) << space;
            EXPECT_NEAR(At(image, "P.Y", p), y, 0.01);
            EXPECT_NEAR(At(image, "P.Z", p) - z, std::copysign(x, At(image, "P.Z", p) - z), 0.01);
            const float n[3]{At(image, "N.X", p), At(image, "N.Y", p), At(image, "N.Z", p)};
            EXPECT_NEAR(std::abs(n[0]), std::sqrt(0.5f), 1e-4);
            EXPECT_NEAR(n[1], 0, 1e-4);
            EXPECT_NEAR(std::abs(n[2]), std::sqrt(0.5f), 1e-4);
            EXPECT_NEAR(n[0], At(image, "Ns.X", p), 1e-5);
            // A pixel is 1/8 wide, the slope 1.
            EXPECT_NEAR(std::abs(At(image, "dzdx", p)), 0.125, 1e-3);
            EXPECT_NEAR(At(image, "dzdy", p), 0, 1e-3);
        }
        // Depth grows along x as the slopes say.
        const float step = At(image, "P.Z", {9, 8}) - At(image, "P.Z", {8, 8});
        EXPECT_NEAR(step, At(image, "dzdx"), 0.01) << space;
    }
}

/// Of a camera that is mirrored as well.
TEST(GBufferFilm, SlopesAreThoseOfNeighbours) {
    for (const std::string mirror : {"", "Scale -1 1 1\n", "Scale 1 -1 1\n"}) {
        const Image image =
            RenderText(mirror + Scene(GBuffer("camera"),
                                      Surroundings("\"spectrum L\" [ 300 1 900 1 ]") +
                                          "Translate 0 0 2 Rotate 30 1 0 0 Rotate 20 0 1 0\n"
                                          "Shape \"disk\" \"float radius\" 9\n",
                                      256));
        const auto step = [&](Point2i to) {
            return At(image, "P.Z", to) - At(image, "P.Z", {8, 8});
        };
        EXPECT_GT(std::abs(step({8, 9})), 0.05);
        // Noise as above, of two pixels.
        EXPECT_NEAR(step({9, 8}), At(image, "dzdx"), 0.015) << mirror;
        EXPECT_NEAR(step({8, 9}), At(image, "dzdy"), 0.015) << mirror;
    }
}

TEST(GBufferFilm, HoldsAlbedoAndVariance) {
    const Image image = RenderText(Scene(GBuffer("camera"), Slope(), 256));
    for (int c = 0; c < 3; ++c) {
        const std::string rgb(1, "RGB"[c]);
        // Colour noise of 256 samples of four wavelengths.
        EXPECT_NEAR(At(image, ("Albedo." + rgb).c_str()), 0.3, 0.03) << rgb;
        const float variance = At(image, ("Variance." + rgb).c_str());
        EXPECT_GT(variance, 0);
        // Over the samples' own mean, which the filter does not weigh.
        EXPECT_NEAR(
            At(image, ("RelativeVariance." + rgb).c_str()) * image.Get({8, 8}, c) / variance, 1,
            0.1);
    }
}

TEST(GBufferFilm, VarianceTellsTheErrorOfThePicture) {
    // Variance of the pixels' means over seeds is that of the samples over their number, with
    // independent ones and equal weights.
    std::string text = Scene(GBuffer("camera"), Slope(), 16);
    text.replace(text.find("zsobol"), 6, "independent");
    text.insert(text.find("WorldBegin"), "PixelFilter \"box\"\n");
    const Image a = RenderText(text), b = RenderText(text, {.seed = 1});
    double squares = 0, variances = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            squares += Sqr(a.Get({x, y}, 1) - b.Get({x, y}, 1)) / 2;
            variances += At(a, "Variance.G", {x, y}) / 16;
        }
    // 256 squares of normal deviates: standard error of their mean 9 %; 4 of those.
    EXPECT_NEAR(squares / variances, 1, 0.36);
}

TEST(GBufferFilm, NothingSeenIsNought) {
    const Image image = RenderText(Scene(GBuffer("world"), Surroundings("\"rgb L\" [ 1 1 1 ]"), 4));
    for (const char *channel : {"P.X", "P.Z", "N.X", "Ns.Z", "Albedo.G", "u", "dzdx"})
        EXPECT_EQ(At(image, channel), 0) << channel;
}

TEST(Films, SameBitsForAnyNumberOfThreads) {
    for (const std::string &film :
         {Spectral(11, 380, 780), GBuffer("camera"), std::string("\"rgb\"")}) {
        const Image one = RenderText(Scene(film, Slope(), 4), {.nThreads = 1}),
                    two = RenderText(Scene(film, Slope(), 4), {.nThreads = 2});
        EXPECT_EQ(one.Data(), two.Data()) << film;
    }
}

TEST(Films, GBufferDoesNotChangeThePicture) {
    const Image rgb = RenderText(Scene("\"rgb\"", Slope(), 4)),
                more = RenderText(Scene(GBuffer("camera"), Slope(), 4));
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(rgb.Get({x, y}, c), more.Get({x, y}, c));
}

}  // namespace
}  // namespace pbrt::test
