// What Embree cannot trace is refused at its line; the rest is traced however large or small.

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

std::string Scene(const std::string &world, const std::string &camera =
                                                "LookAt 0 0 3  0 0 0  0 1 0\nCamera "
                                                "\"perspective\" \"float fov\" 40\n") {
    return "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16\nPixelFilter "
           "\"box\"\n"
           "Sampler \"stratified\" \"integer xsamples\" 2 \"integer ysamples\" 2\n" +
           camera + "WorldBegin\nLightSource \"infinite\"\n" + world;
}

/// The first error of a scene; empty where there is none.
std::string Refusal(const std::string &text) {
    Diagnostics log;
    SceneDescription description;
    ParseString(text, "test.pbrt", ".", description, log);
    EXPECT_FALSE(log.HasErrors()) << text;
    const auto task = MakeRenderTask(std::move(description), {}, log);
    EXPECT_EQ(!task, log.HasErrors());
    for (const Message &m : log.Messages())
        if (m.severity == Severity::Error) return m.text;
    return "";
}
void ExpectRefused(const std::string &text, const std::string &place, const std::string &why) {
    const std::string said = Refusal(text);
    EXPECT_EQ(said.find("test.pbrt:" + place), 0u) << said << "\n" << text;
    EXPECT_NE(said.find(why), said.npos) << said << "\n" << text;
}

std::string Instance(const std::string &shape, const std::string &use) {
    return "AttributeBegin\nObjectBegin \"o\"\n" + shape + "\nObjectEnd\nAttributeEnd\n" + use +
           " ObjectInstance \"o\"\n";
}
std::string Scale(double s) {
    return fmt::format("Scale {0:.9g} {0:.9g} {0:.9g}", s);
}

TEST(Range, ShapesBeyondWhatIsTracedAreRefused) {
    for (const char *shape :
         {"Shape \"disk\" \"float radius\" 1e19", "Shape \"sphere\" \"float radius\" 1e19",
          "Shape \"cylinder\" \"float radius\" .5 \"float zmin\" -1e19 \"float zmax\" 1e19",
          "Shape \"trianglemesh\" \"point3 P\" [ -1e19 0 0 1e19 0 0 0 1 0 ]",
          "Shape \"bilinearmesh\" \"point3 P\" [ -1e19 -1e19 -1 1e19 -1e19 -1 -1e19 1e19 -1 1e19 "
          "1e19 "
          "0 ]",
          "Shape \"curve\" \"point3 P\" [ 0 0 0 1 0 0 2 0 0 1e19 0 0 ]",
          "Shape \"curve\" \"point3 P\" [ 0 0 0 1 0 0 2 0 0 3 0 0 ] \"float width\" 1e19"}) {
        ExpectRefused(Scene(shape), "8:1", "can be traced");
        ExpectRefused(Scene(Instance(shape, "")), "10:1", "can be traced");
    }
    ExpectRefused(Scene(Instance("Shape \"sphere\" \"float radius\" 1e9", Scale(1e9))), "13:25",
                  "it reaches to 1e+18");
}

TEST(Range, InstancesThatEmbreeCannotInvertAreRefused) {
    const std::string sphere = "Shape \"sphere\"";
    for (double s : {1e-13, 1e-17, 1e-30, 1e13}) {
        const std::string shape = fmt::format("{} \"float radius\" {:.9g}", sphere, 1 / s);
        const std::string small = s < 1e-17 ? sphere : shape;
        ExpectRefused(Scene(Instance(small, Scale(s))), "13:", "scales volumes by");
        ExpectRefused(Scene(Scale(s) + "\nActiveTransform EndTime Translate 1 0 0\n" + small),
                      "10:1", "scales volumes by");
    }
    ExpectRefused(Scene(Instance(sphere, "Rotate 40 1 2 3 Scale 1 1 1e-8 Rotate 30 3 1 2")),
                  "13:", "so flat or skewed");
    ExpectRefused(
        Scene(Instance(sphere, "ActiveTransform EndTime Scale -1 1 1 ActiveTransform All")),
        "13:", "mirrored at one end");
    ExpectRefused(Scene(Instance(sphere, "Transform [ 1 0 0 .1 0 1 0 0 0 0 1 0 0 0 0 1 ]")),
                  "13:", "perspective");
    // By itself it could be, but not from this far.
    ExpectRefused(Scene(Instance("Shape \"sphere\" \"float radius\" 1e10", Scale(1e-10)),
                        "LookAt 0 0 1e9 0 0 0 0 1 0\nCamera \"perspective\"\n"),
                  "13:25", "this scene's rays reach to");
}

TEST(Range, CamerasAndLightsToo) {
    const auto camera = [](const std::string &before, const std::string &parameters) {
        return Scene("Shape \"sphere\"", before + "\nCamera \"perspective\" " + parameters + "\n");
    };
    ExpectRefused(camera(Scale(1e30), ""), "5:1", "cannot be traced");
    ExpectRefused(camera(Scale(1e-30), ""), "5:1", "cannot be traced");
    ExpectRefused(camera("", "\"float screenwindow\" [ -1e30 1e30 -1e30 1e30 ]"), "5:1",
                  "screen window");
    ExpectRefused(camera("", "\"float lensradius\" 2e18"), "5:41", "outside [0, 5e+17]");
    ExpectRefused(camera(Scale(1e-10), "\"float lensradius\" 1e10"), "5:1", "lens");
    ExpectRefused(camera("", "\"float lensradius\" 1 \"float focaldistance\" 1e25"), "5:65",
                  "outside");
    ExpectRefused(Scene("LightSource \"point\" \"point3 from\" [ 1e30 0 0 ]"), "8:21",
                  "stands beyond");
    ExpectRefused(
        Scene("LightSource \"distant\" \"point3 from\" [ 0 0 1e-30 ] \"point3 to\" [ 0 0 0 ]"),
        "8:", "the distance of");
    ExpectRefused(Scene("LightSource \"spot\" \"point3 to\" [ 0 0 1e30 ]"), "8:20",
                  "the distance of");
    ExpectRefused(Scene(Scale(1e-30) + "\nLightSource \"spot\""), "9:1",
                  "its transformation scales");
}

/// A unit ball is the same whether radius or scale make it large; normals and tangents over- or
/// underflowed where one undid the other.
TEST(Range, WhatIsLargeInItsOwnSpaceIsTraced) {
    const auto picture = [](const std::string &shape) {
        // Its own light and a normal that shows.
        return RenderText(
            Scene("LightSource \"point\" \"point3 from\" [ 2 3 4 ] \"float scale\" 20\n"
                  "Material \"conductor\" \"float uroughness\" .4 \"float vroughness\" .1\n" +
                  shape));
    };
    for (const char *form : {"Shape \"sphere\" \"float radius\" {0:.9g}",
                             "Shape \"sphere\" \"float radius\" {0:.9g} \"float zmax\" {1:.9g}",
                             "Rotate 60 1 1 0 Shape \"cylinder\" \"float radius\" {0:.9g} \"float "
                             "zmin\" -{0:.9g} \"float zmax\" {1:.9g}",
                             "Rotate 30 1 1 0 Shape \"disk\" \"float radius\" {0:.9g} \"float "
                             "innerradius\" {1:.9g} \"float height\" {1:.9g}",
                             "Shape \"trianglemesh\" \"point3 P\" [ -{0:.9g} -{0:.9g} 0  {0:.9g} "
                             "-{0:.9g} 0  -{0:.9g} {0:.9g} 0 ] "
                             "\"normal N\" [ -.2 .1 1 .4 0 1 .1 -.3 1 ]"}) {
        const auto shape = [&](double unit) {
            return Scale(1 / unit) + "\n" + fmt::format(fmt::runtime(form), unit, unit / 2) + "\n";
        };
        const Image one = picture(shape(1));
        EXPECT_GT(Mean(one)[1], 0.1);
        for (double unit : {0x1p40, 0x1p60, 0x1p-40, 0x1p-60}) {
            // By powers of two: but for the steps of a hit's double, bit for bit.
            const Image other = picture(shape(unit));
            for (size_t i = 0; i < one.Data().size(); ++i)
                EXPECT_NEAR(one.Data()[i], other.Data()[i], 1e-4f * (1 + one.Data()[i]))
                    << form << unit;
        }
    }
    // So are instances, as far as they can be inverted.
    const Image one = picture("Shape \"sphere\"");
    for (double s : {0x1p39, 0x1p-39}) {
        const Image other = picture(
            Instance(fmt::format("Shape \"sphere\" \"float radius\" {:.9g}", 1 / s), Scale(s)));
        EXPECT_NEAR(Mean(one)[1], Mean(other)[1], 1e-3 * Mean(one)[1]) << s;
    }
}

}  // namespace
}  // namespace pbrt::test
