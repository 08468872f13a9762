// Paths are traced side by side; who is beside whom must not matter.

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// Every kind of surface and light that is treated apart: plain and not, with gaps, one by one. But
/// no mix, which chooses by a hash of the place, so that any rounding changes the choice.
std::string Everything(const std::string &film, int spp) {
    return fmt::format(
        "LookAt 0 1 -4  0 0.4 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
        "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16 {}\n"
        "Sampler \"zsobol\" \"integer pixelsamples\" {}\nIntegrator \"path\" \"integer maxdepth\" "
        "6\nWorldBegin\n"
        "LightSource \"infinite\" \"rgb L\" [ .3 .4 .5 ]\n"
        "LightSource \"point\" \"rgb I\" [ 3 2 1 ] \"point3 from\" [ 1 2 -2 ]\n"
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 4 4 4 ] Translate 0 3 0\n"
        "Rotate 90 1 0 0 Shape \"disk\" AttributeEnd\n"
        "Texture \"t\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [ .2 .5 .7 ] \"rgb tex2\" [ .8 "
        ".8 .8 ]\n"
        "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"texture reflectance\" \"t\"\n"
        "MakeNamedMaterial \"b\" \"string type\" \"conductor\" \"float roughness\" .1\n"
        "NamedMaterial \"a\" Shape \"bilinearmesh\" \"point3 P\" [ -3 0 -3 3 0 -3 -3 0 3 3 0 3 ]\n"
        "AttributeBegin Material \"dielectric\" Translate -1 .5 0 Shape \"sphere\" \"float "
        "radius\" .5 AttributeEnd\n"
        "AttributeBegin Material \"featherbarbule\" Translate 0 .5 0 Shape \"sphere\" \"float "
        "radius\" .5 AttributeEnd\n"
        "AttributeBegin NamedMaterial \"b\" Translate 0 1.2 0 Shape \"sphere\" \"float radius\" .2 "
        "AttributeEnd\n"
        "AttributeBegin Material \"coateddiffuse\" Translate 1 .5 0 Shape \"sphere\" \"float "
        "radius\" .5 AttributeEnd\n"
        "ObjectBegin \"o\" Material \"diffuse\" Shape \"sphere\" \"float radius\" .2 ObjectEnd\n"
        "AttributeBegin Translate .5 .2 -1 ObjectInstance \"o\" AttributeEnd\n"
        "AttributeBegin Translate -.5 .2 -1 ObjectInstance \"o\" AttributeEnd\n",
        film, spp);
}

/// A path's neighbours decide which of its formulas are worked out side by side; that changes
/// roundings, by which a path may go another way after some bounces off balls: two of 121 here in a
/// build without optimisation, none with it. Six may.
void ExpectSameButForRounding(const Image &whole, const Image &part, Point2i offset) {
    const Point2i n = part.Resolution();
    int different = 0;
    for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x)
            for (int c = 0; c < 3; ++c) {
                const float a = whole.Get({x + offset.x, y + offset.y}, c), b = part.Get({x, y}, c);
                different += !(std::abs(a - b) <= 1e-3f * (0.1f + a));
            }
    EXPECT_LE(different, 6 * 3);
}

TEST(Batches, APartOfThePictureIsThatPart) {
    const Image whole = RenderText(Everything("", 1));
    const Image part = RenderText(Everything("\"integer pixelbounds\" [ 5 16 3 14 ]", 1));
    ASSERT_EQ(part.Resolution(), (Point2i{11, 11}));
    ExpectSameButForRounding(whole, part, {5, 3});
}

TEST(Batches, SamplesBeyondOneBatch) {
    // 8192 samples of a pixel are four batches, 1024 half a one. Significance: 4 standard errors of
    // sixteen pictures with 1024.
    const std::string film = "\"integer pixelbounds\" [ 10 13 8 10 ]";
    constexpr int kRuns = 16;
    std::array<double, 3> sum{}, squares{}, many{};
    for (int seed = 0; seed < kRuns; ++seed) {
        const auto few = Mean(RenderText(Everything(film, 1024), {.seed = seed}));
        for (size_t c = 0; c < 3; ++c)
            sum[c] += few[c], squares[c] += few[c] * few[c];
    }
    for (int seed = 100; seed < 102; ++seed) {
        const auto mean = Mean(RenderText(Everything(film, 8192), {.seed = seed}));
        for (size_t c = 0; c < 3; ++c)
            many[c] += mean[c] / 2;
    }
    for (size_t c = 0; c < 3; ++c) {
        const double mean = sum[c] / kRuns;
        const double variance = squares[c] / kRuns - mean * mean;
        EXPECT_NEAR(many[c], mean, 4 * std::sqrt(2 * variance / (kRuns - 1))) << c;
    }
}

TEST(Batches, TheSameBitsForAnyNumberOfThreads) {
    EXPECT_EQ(RenderText(Everything("", 16), {.nThreads = 1}).Data(),
              RenderText(Everything("", 16), {.nThreads = 2}).Data());
}

}  // namespace
}  // namespace pbrt::test
