#include "lights/light_scene.h"

namespace pbrt::test {
namespace {

/// Colour of a constant infinite light.
RGB ColorOf(const std::string &params) {
    const LightScene s("LightSource \"infinite\" " + params);
    const auto &light = std::get<UniformInfiniteLight>(s.Only());
    // SpectrumToXYZ is relative to the constant 1.
    const XYZ xyz = SpectrumToXYZ(light.radiance->Scaled(light.scale * CIE_Y_integral));
    return RGBColorSpace::sRGB().ToRGB(xyz);
}
float LuminanceOf(const std::string &params) {
    const LightScene s("LightSource \"infinite\" " + params);
    const auto &light = std::get<UniformInfiniteLight>(s.Only());
    return light.luminance * light.scale;
}

TEST(Emission, RGBOneIsPixelValueOne) {
    for (const char *params : {"\"rgb L\" [ 1 1 1 ]", ""}) {
        const RGB c = ColorOf(params);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(c[i], 1, 2e-3) << params;
    }
}

TEST(Emission, RGBValuesSurvive) {
    const RGB want{16, 14, 11}, got = ColorOf("\"rgb L\" [ 16 14 11 ]");
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], want[i], 5e-3f * want[i]);
}

TEST(Emission, OnlyTheShapeOfASpectrumMatters) {
    EXPECT_NEAR(LuminanceOf("\"spectrum L\" [ 400 1 700 3 ]"), 1, 1e-4);
    EXPECT_NEAR(LuminanceOf("\"spectrum L\" [ 400 20 700 60 ]"), 1, 1e-4);
    EXPECT_NEAR(LuminanceOf("\"blackbody L\" 3000"), 1, 1e-4);
    EXPECT_NEAR(LuminanceOf("\"spectrum L\" \"stdillum-A\""), 1, 1e-4);
    EXPECT_NEAR(LuminanceOf("\"blackbody L\" 3000 \"float scale\" 7"), 7, 1e-3);
}

TEST(Emission, BlackRGBIsALightThatGivesNothing) {
    EXPECT_EQ(LuminanceOf("\"rgb L\" [ 0 0 0 ]"), 0);
}

TEST(Emission, ASpectrumWithoutVisibleLightIsAnError) {
    const LightScene s("LightSource \"point\" \"spectrum I\" [ 900 1 1000 1 ]");
    EXPECT_EQ(s.Messages(),
              "l.pbrt:2:21: \"I\" has no visible light: its level is set by `scale`, "
              "its shape must not be 0 from 360 to 830 nm\n");
}

TEST(LightErrors, UnknownTypesAndParameters) {
    EXPECT_EQ(LightScene("LightSource \"pint\"").Messages(),
              "l.pbrt:2:1: unknown light \"pint\"; did you mean \"point\"? Known: " +
                  QuotedList(LightNames()) + '\n');
    EXPECT_EQ(AreaScene("\"difuse\"", Rectangle(1, 1, 0)).Messages(),
              "l.pbrt:2:1: unknown area light \"difuse\"; did you mean \"diffuse\"? Known: "
              "\"diffuse\"\n");
    EXPECT_NE(LightScene("LightSource \"infinite\" \"point3 portal\" [ 0 0 0 ]")
                  .Messages()
                  .find("unknown parameter \"point3 portal\" of light \"infinite\""),
              std::string::npos);
    EXPECT_NE(AreaScene("\"diffuse\" \"string filename\" \"a.exr\"", Rectangle(1, 1, 0))
                  .Messages()
                  .find("unknown parameter \"string filename\" of area light \"diffuse\""),
              std::string::npos);
}

TEST(LightErrors, ADirectionNeedsTwoPoints) {
    EXPECT_EQ(LightScene("LightSource \"spot\" \"point3 from\" [ 1 2 3 ] \"point3 to\" [ 1 2 3 ]")
                  .Messages(),
              "l.pbrt:2:44: \"from\" and \"to\" are the same point: no direction\n");
    EXPECT_NE(LightScene("LightSource \"distant\" \"point3 to\" [ 0 0 0 ]").Messages(), "");
}

TEST(LightErrors, RangesAreChecked) {
    EXPECT_NE(LightScene("LightSource \"spot\" \"float coneangle\" 200").Messages(), "");
    EXPECT_NE(LightScene("LightSource \"point\" \"float scale\" -1").Messages(), "");
}

}  // namespace
}  // namespace pbrt::test
