// Option "forcediffuse": every surface is diffuse and reflects as much as its material does.

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

constexpr std::string_view kForced = "Option \"forcediffuse\" true\n";

std::string Scene(std::string_view option, const std::string &world) {
    return fmt::format(
        "{}LookAt 0 0 0  0 0 -1  0 1 0\n"
        "Camera \"orthographic\" \"float screenwindow\" [ -1 1 -1 1 ]\n"
        "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
        "Sampler \"independent\" \"integer pixelsamples\" 16\n"
        "Integrator \"path\" \"integer maxdepth\" 1\nWorldBegin\n{}",
        option, world);
}

std::string Layer(float z) {
    return fmt::format(
        "Shape \"bilinearmesh\" \"point3 P\" [ -40 -40 {0}  40 -40 {0}  -40 40 {0}  "
        "40 40 {0} ]\n",
        z);
}

/// Seen at right angles, lit from 45 degrees.
std::string LitPlate(const std::string &material) {
    return "LightSource \"distant\" \"point3 from\" [ 1 0 0 ] \"point3 to\" [ 0 0 -1 ]\n"
           "Material " +
           material + "\n" + Layer(-5);
}

TEST(ForceDiffuse, AMirrorIsAMattSurfaceOfItsReflectance) {
    const std::string mirror =
        LitPlate("\"conductor\" \"rgb reflectance\" [ 0.5 0.5 0.5 ] \"float roughness\" 0");
    const auto diffuse =
        Mean(RenderText(Scene("", LitPlate("\"diffuse\" \"rgb reflectance\" [ 0.5 0.5 0.5 ]"))));
    EXPECT_EQ(Mean(RenderText(Scene("", mirror)))[1], 0);
    // Some ten roundings of floats between k, Fresnel's formula and the mean of 16.
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(Mean(RenderText(Scene(kForced, mirror)))[size_t(c)] / diffuse[size_t(c)], 1,
                    32 * 0x1p-24);
}

TEST(ForceDiffuse, GlassReflectsWhatItLetsThrough) {
    // Index 1: all light passes, so that the albedo is 1.
    const auto white =
        Mean(RenderText(Scene("", LitPlate("\"diffuse\" \"rgb reflectance\" [ 1 1 1 ]"))));
    const auto glass = Mean(RenderText(Scene(kForced, LitPlate("\"dielectric\" \"float eta\" 1"))));
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(glass[c] / white[c], 1, 32 * 0x1p-24);
}

TEST(ForceDiffuse, MattSurfacesStayAsTheyAre) {
    const std::string world =
        "LightSource \"infinite\"\nTranslate 0 0 -3\n"
        "Material \"diffuse\" \"rgb reflectance\" [ 0.2 0.5 0.8 ]\nShape \"sphere\" \"float "
        "radius\" 0.8\n";
    const Image plain = RenderText(Scene("", world)), forced = RenderText(Scene(kForced, world));
    for (size_t i = 0; i < plain.Data().size(); ++i)
        EXPECT_NEAR(forced.Data()[i], plain.Data()[i], 32 * 0x1p-24 * plain.Data()[i]);
}

TEST(ForceDiffuse, FeathersLetNoLightThrough) {
    const std::string vane = "Material \"featherbarbule\" \"float spacing\" 4\n";
    // Paths: a lamp behind the vane. Shadow rays: a lamp above the vane, the camera below it.
    const std::string lamp = vane + Layer(-5) + "AttributeBegin AreaLightSource \"diffuse\"\n" +
                             Layer(-6) + "AttributeEnd\n";
    const std::string shadow = vane + Layer(1) +
                               "LightSource \"point\" \"point3 from\" [ 0 0 2 ]\n" +
                               "Material \"diffuse\"\n" + Layer(-5);
    for (const std::string &world : {lamp, shadow}) {
        EXPECT_GT(Mean(RenderText(Scene("", world)))[1], 0);
        EXPECT_EQ(Mean(RenderText(Scene(kForced, world)))[1], 0);
    }
}

}  // namespace
}  // namespace pbrt::test
