// The world and the camera agree in every rendering space, at any distance from the origin.

#include <fmt/format.h>

#include "pbrt/util/rng.h"
#include "render/cases.h"
#include "render/render_text.h"

namespace pbrt::test {
namespace {

constexpr std::array<const char *, 3> kSpaces{"cameraworld", "world", "camera"};

std::string Replaced(std::string text, const std::string &from, const std::string &to) {
    for (size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}
std::string In(const std::string &space, const std::string &scene) {
    return "Option \"rendercoordsys\" \"" + space + "\"\n" + scene;
}

Camera CameraOf(const std::string &text) {
    Diagnostics log;
    SceneDescription scene;
    ParseString(text, "test.pbrt", ".", scene, log);
    EXPECT_FALSE(log.HasErrors());
    return CreateCamera(scene, {32, 32}, log);
}

TEST(RenderingSpace, IsTheWorldOrTheWorldMoved) {
    Rng rng(1);
    const auto number = [&] { return 20 * rng.Uniform() - 10; };
    for (int i = 0; i < 100; ++i) {
        const Point3f eye{1e5f * number(), number(), 1e-3f * number()};
        const std::string camera = fmt::format(
            "{}LookAt {} {} {}  {} {} {}  {} {} {}\nCamera \"perspective\"\nWorldBegin\n",
            i % 2 ? "Scale -1 1 1\n" : "", eye.x, eye.y, eye.z, number(), number(), number(),
            number(), number(), number());
        const Transform inWorld = Placement(CameraOf(In("world", camera))).renderFromWorld;
        EXPECT_TRUE(inWorld == Transform());
        const Camera moved = CameraOf(In("cameraworld", camera));
        EXPECT_EQ(Placement(moved).renderFromWorld, Transform::Translate(-eye));
        EXPECT_EQ(Placement(moved).renderFromCamera.Point({}), Point3f{});
        EXPECT_TRUE(Placement(CameraOf(In("camera", camera))).renderFromCamera == Transform());
    }
}

TEST(RenderingSpace, FarFromTheOriginNothingMoves) {
    const std::string far = Case("far-from-origin.pbrt");
    const std::string near = Replaced(Replaced(far, "Translate 1048576 2097152 -1048576\n", ""),
                                      "LookAt 1048574 2097156 -1048573  1048576 2097152 -1048576",
                                      "LookAt -2 4 3  0 0 0");
    ASSERT_NE(near, far);
    const Image expected = RenderText(near);
    EXPECT_EQ(RenderText(In("cameraworld", far)).Data(), expected.Data());
    // Hits are rounded to 1/8, on which the light of the square does not depend.
    EXPECT_EQ(RenderText(In("world", far)).Data(), expected.Data());
    // In camera space the camera's turn, rounded to 6e-8, moves what is 2e6 away from the origin.
}

TEST(RenderingSpace, GroundDoesNotShadowItself) {
    const std::string ground = Replaced(Case("ground-sphere.pbrt"), "\"integer pixelsamples\" 64",
                                        "\"integer pixelsamples\" 4");
    for (const char *space : kSpaces)
        for (const char *radius : {"1000", "10000", "1000000"})
            for (const char *turn :
                 {"", "Rotate 90 0 0 1\n", "Rotate 17 1 2 3\n", "Scale 1 1 -1\n"}) {
                const std::string shape = fmt::format("{}Shape \"sphere\"", turn);
                const Image image = RenderText(In(
                    space, Replaced(Replaced(ground, "Shape \"sphere\"", shape), "10000", radius)));
                const Point2i n = image.Resolution();
                float least = 1;
                for (int y = 0; y < n.y; ++y)
                    for (int x = 0; x < n.x; ++x)
                        least = std::min(least, image.Get({x, y}, 1));
                // Four wavelengths a sample: green is off by 4 % at most where nothing is missing,
                // and 1/4 at least where one of the four samples is black.
                EXPECT_GT(least, 0.9f) << space << " " << radius << " " << turn;
            }
}

}  // namespace
}  // namespace pbrt::test
