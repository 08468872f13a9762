// Each sampler in a scene: no complaint, and the image's mean is zsobol's.

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

constexpr Point2i kResolution{48, 32};

/// A sphere on a plane; sampler, integrator.
std::string Scene(std::string_view sampler, std::string_view integrator) {
    return fmt::format(
        "LookAt 0 1.5 6  0 0.5 0  0 1 0\nCamera \"perspective\" \"float fov\" 35\n"
        "Film \"rgb\" \"integer xresolution\" {} \"integer yresolution\" {}\n"
        "Sampler {}\nIntegrator \"{}\"\nWorldBegin\n"
        "LightSource \"infinite\" \"rgb L\" [ 0.5 0.5 0.5 ]\n"
        "LightSource \"distant\" \"point3 from\" [ 2 3 4 ] \"rgb L\" [ 2 2 2 ]\n"
        "Material \"diffuse\" \"rgb reflectance\" [ 0.6 0.6 0.6 ]\n"
        "Shape \"trianglemesh\" \"point3 P\" [ -9 -1 -9  9 -1 -9  9 -1 9  -9 -1 9 ]\n"
        "  \"integer indices\" [ 0 1 2 0 2 3 ]\n"
        "Material \"diffuse\" \"rgb reflectance\" [ 0.7 0.2 0.1 ]\nShape \"sphere\"\n",
        kResolution.x, kResolution.y, sampler, integrator);
}

class SamplerInAScene : public ::testing::TestWithParam<std::string_view> {};

TEST_P(SamplerInAScene, HasTheMeanOfZSobol) {
    for (const char *integrator : {"path", "simplepath"}) {
        const Image image = RenderText(Scene(GetParam(), integrator));
        static const Image reference =
            RenderText(Scene("\"zsobol\" \"integer pixelsamples\" 256", "path"));
        // Noise of the means from that of pixels; 4 sigma, and one for what pixels share.
        for (int c = 0; c < 3; ++c) {
            double sum = 0, squares = 0;
            for (int y = 0; y < kResolution.y; ++y) {
                for (int x = 0; x < kResolution.x; ++x) {
                    const double d = double(image.Get({x, y}, c)) - reference.Get({x, y}, c);
                    sum += d, squares += d * d;
                }
            }
            EXPECT_LT(std::abs(sum), 5 * std::sqrt(squares)) << integrator;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SamplerInAScene,
    ::testing::Values("\"halton\" \"integer pixelsamples\" 16",
                      "\"halton\" \"integer pixelsamples\" 8 \"string randomization\" \"owen\"",
                      "\"halton\" \"integer pixelsamples\" 8 \"string randomization\" \"none\"",
                      "\"sobol\"", "\"sobol\" \"string randomization\" \"none\"", "\"paddedsobol\"",
                      "\"pmj02bn\""),
    [](const auto &info) {
        std::string name;
        for (char c : info.param)
            if (std::isalnum(c)) name += c;
        return name;
    });

/// Without randomisation all pixels share the same 16 points, which lie at the lower ends of their
/// intervals: so their error is shared, too, some 1 / 32.
TEST(SamplerWithoutRandomization, IsNearby) {
    const auto mean =
        Mean(RenderText(Scene("\"paddedsobol\" \"string randomization\" \"none\"", "path")));
    const auto expected =
        Mean(RenderText(Scene("\"zsobol\" \"integer pixelsamples\" 256", "path")));
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(mean[c] / expected[c], 1, 1 / 32.0);
}

}  // namespace
}  // namespace pbrt::test
