// Closed scenes whose radiance is known to be 1 everywhere (as PBRT_FORMAT 5.2,
// AnalyticTestScenes).

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// Inside of a unit sphere; every point sends 1 towards every other.
struct AnalyticScene {
    std::string name, world;
};

const std::vector<AnalyticScene> &Scenes() {
    // A point light of intensity pi at the centre: irradiance pi, times albedo 0.5 / pi, and the
    // infinite series of bounces doubles it: 0.5 / (1 - 0.5) = 1.
    static const std::vector<AnalyticScene> scenes{
        {"OnePointLight",
         "LightSource \"point\" \"spectrum I\" [ 300 1 900 1 ] \"float scale\" 3.14159265\n"
         "Material \"diffuse\" \"spectrum reflectance\" [ 300 0.5 900 0.5 ]\n"
         "ReverseOrientation Shape \"sphere\" \"float radius\" 1\n"},
        {"FourPointLights",
         [] {
             std::string s;
             for (int i = 0; i < 4; ++i)
                 s += "LightSource \"point\" \"spectrum I\" [ 300 1 900 1 ] "
                      "\"float scale\" 0.785398163\n";
             return s;
         }() +
             "Material \"diffuse\" \"spectrum reflectance\" [ 300 0.5 900 0.5 ]\n"
             "ReverseOrientation Shape \"sphere\" \"float radius\" 1\n"},
        {"EmissiveSphere",
         "AreaLightSource \"diffuse\" \"spectrum L\" [ 300 1 900 1 ] \"float scale\" 0.5\n"
         "Material \"diffuse\" \"spectrum reflectance\" [ 300 0.5 900 0.5 ]\n"
         "ReverseOrientation Shape \"sphere\" \"float radius\" 1\n"},
    };
    return scenes;
}

using Case = std::tuple<int, std::string, std::string, std::string>;

class RadianceIsOne : public ::testing::TestWithParam<Case> {};

TEST_P(RadianceIsOne, Within2_5Percent) {
    const auto &[scene, integrator, camera, sampler] = GetParam();
    const std::string text = fmt::format(
        "Film \"rgb\" \"integer xresolution\" 10 \"integer yresolution\" 10\n"
        "Sampler {}\nIntegrator \"{}\" \"integer maxdepth\" 8\nCamera \"{}\" {}\nWorldBegin\n{}",
        sampler, integrator, camera,
        camera == "orthographic" ? "\"float screenwindow\" [ -.1 .1 -.1 .1 ]" : "\"float fov\" 45",
        Scenes()[scene].world);
    // Eight bounces leave out 0.5^8 = 0.4 %.
    const std::array<double, 3> mean = Mean(RenderText(text));
    // The spectra are constant: their colour is the equal-energy white, whose Y is what is 1.
    const XYZ xyz = RGBColorSpace::sRGB().ToXYZ({float(mean[0]), float(mean[1]), float(mean[2])});
    EXPECT_NEAR(xyz.Y, 1, 0.025);
}

INSTANTIATE_TEST_SUITE_P(
    Analytic, RadianceIsOne,
    ::testing::Combine(
        ::testing::Values(0, 1, 2), ::testing::Values("path", "volpath"),
        ::testing::Values("perspective", "orthographic"),
        ::testing::Values(
            "\"independent\" \"integer pixelsamples\" 256",
            "\"stratified\" \"integer xsamples\" 16 \"integer ysamples\" 16",
            "\"zsobol\" \"integer pixelsamples\" 256",
            "\"zsobol\" \"integer pixelsamples\" 256 \"string randomization\" \"owen\"",
            "\"zsobol\" \"integer pixelsamples\" 256 \"string randomization\" \"permutedigits\"",
            "\"halton\" \"integer pixelsamples\" 256", "\"sobol\" \"integer pixelsamples\" 256",
            "\"paddedsobol\" \"integer pixelsamples\" 256",
            "\"pmj02bn\" \"integer pixelsamples\" 256")),
    [](const auto &info) {
        std::string name = Scenes()[std::get<0>(info.param)].name + std::get<1>(info.param) +
                           std::get<2>(info.param) + std::to_string(info.index);
        return name;
    });

}  // namespace
}  // namespace pbrt::test
