// Kinds of textures, pictures, lights and shapes that scenes of others use, in small scenes of
// which it is known what must be seen.

#include <fmt/format.h>

#include "render/render_text.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

/// 16 x 16 pixels of [-2, 2]^2 in z = 0, looked at along +z with y up, x to the right; light of
/// radiance 1 from everywhere, which is seen directly or by one reflection.
std::string Seen(const std::string &world) {
    return "LookAt 0 0 -5  0 0 0  0 1 0\n"
           "Camera \"orthographic\" \"float screenwindow\" [ -2 2 -2 2 ]\n"
           "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16\n"
           "PixelFilter \"box\" Sampler \"zsobol\" \"integer pixelsamples\" 64\n"
           "Integrator \"path\" \"integer maxdepth\" 1\n"
           "WorldBegin LightSource \"infinite\" \"rgb L\" [ 1 1 1 ]\n" +
           world;
}
constexpr char kQuad[] = "Shape \"bilinearmesh\" \"point3 P\" [ -2 -2 0  2 -2 0  -2 2 0  2 2 0 ]\n";

void ExpectPixel(const Image &image, Point2i at, std::array<float, 3> rgb, float tolerance) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image.Get(at, c), rgb[size_t(c)], tolerance) << at.x << ' ' << at.y;
}

TEST(CorpusKinds, DirectionMixTellsTopsFromSides) {
    // A quad on edge, one that leans: the cosine to y is 0, and 0.6.
    const std::string material =
        "Texture \"snow\" \"spectrum\" \"directionmix\" \"rgb tex1\" [ .9 .9 .9 ] \"rgb tex2\" [ "
        ".3 .2 .1 ]\n"
        "Material \"diffuse\" \"texture reflectance\" \"snow\"\n";
    const Image upright = RenderText(Seen(material + kQuad));
    ExpectPixel(upright, {8, 8}, {0.3f, 0.2f, 0.1f}, 0.01f);
    const Image leaning = RenderText(
        Seen(material +
             "Shape \"bilinearmesh\" \"point3 P\" [ -2 -2 -1.5  2 -2 -1.5  -2 2 1.5  2 2 1.5 ]"));
    ExpectPixel(leaning, {8, 8}, {0.66f, 0.62f, 0.58f}, 0.01f);
}

TEST(CorpusKinds, DotsAsAlphaAreHoles) {
    const std::string quad = kQuad;
    const auto seen = [&](const char *inside, const char *outside) {
        return Mean(RenderText(Seen(fmt::format(
            "Texture \"d\" \"float\" \"dots\" \"float uscale\" 16 \"float vscale\" 16 "
            "\"float inside\" {} \"float outside\" {}\n"
            "Material \"diffuse\" \"rgb reflectance\" [ 0 0 0 ]\n{} \"texture alpha\" \"d\"",
            inside, outside, quad))))[1];
    };
    // Holes show the light. Where they are the rest is not.
    const double holes = seen("0", "1"), rest = seen("1", "0");
    EXPECT_GT(holes, 0.08);  // a third of the cells, of which 0.385 is dot
    EXPECT_LT(holes, 0.2);
    EXPECT_NEAR(holes + rest, 1, 0.01);
}

using CorpusFiles = TempFolder;

TEST_F(CorpusFiles, TgaIsSeenUprightFromEitherCorner) {
    for (const bool fromTop : {false, true}) {
        std::string file("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\2\0\x18", 17);
        file += char(fromTop ? 32 : 0);
        const std::string red("\0\0\xff", 3), blue("\xff\0\0", 3);
        file += fromTop ? red + blue : blue + red;
        Put("a.tga", file);
        const Image image =
            RenderText(Seen(fmt::format(
                           "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.tga\" "
                           "\"string filter\" \"point\"\nMaterial \"diffuse\" \"texture "
                           "reflectance\" \"t\"\n{}",
                           kQuad)),
                       {}, folder.string());
        ExpectPixel(image, {8, 2}, {1, 0, 0}, 0.01f);
        ExpectPixel(image, {8, 13}, {0, 0, 1}, 0.01f);
    }
}

TEST_F(CorpusFiles, AreaLightsShowTheirPicture) {
    Image picture({2, 2}, {"R", "G", "B"});
    picture.Set({0, 0}, 0, 1);
    picture.Set({1, 1}, 2, 2);
    ASSERT_EQ(WriteImage(picture, Path("a.exr")), std::nullopt);
    const auto seen = [&](const std::string &more) {
        return RenderText(Seen("Material \"diffuse\" \"rgb reflectance\" [ 0 0 0 ]\n"
                               "AreaLightSource \"diffuse\" \"string filename\" \"a.exr\" "
                               "\"float scale\" 3 \"bool twosided\" true\n" +
                               (kQuad + more)),
                          {}, folder.string());
    };
    const Image image = seen("");
    ExpectPixel(image, {2, 2}, {3, 0, 0}, 0.01f);
    ExpectPixel(image, {13, 13}, {0, 0, 6}, 0.01f);
    ExpectPixel(image, {13, 2}, {0, 0, 0}, 0);
    // Guides pbrt-v4's samples; changes nothing here.
    EXPECT_EQ(seen("\"string emissionfilename\" \"a.exr\"").Data(), image.Data());
}

TEST(CorpusKinds, LoopSubdivIsRoundWithinItsControlPoints) {
    // Black before light: the share of its shadow.
    const Image image = RenderText(Seen(R"(Material "diffuse" "rgb reflectance" [ 0 0 0 ]
        Shape "loopsubdiv" "integer levels" 3 "point3 P" [ 0 1 0  1 0 0  0 0 1  -1 0 0  0 0 -1  0 -1 0 ]
        "integer indices" [ 0 2 1  0 3 2  0 4 3  0 1 4  5 1 2  5 2 3  5 3 4  5 4 1 ])"));
    const double covered = 16 * (1 - Mean(image)[1]);
    // Vertices of four neighbours whose mean is 0 go half way there. The outline is convex: it lies
    // between the square of its four vertices and the circle about them.
    EXPECT_GT(covered, 2 * 0.5 * 0.5);
    EXPECT_LT(covered, M_PI * 0.5 * 0.5);
}

}  // namespace
}  // namespace pbrt::test
