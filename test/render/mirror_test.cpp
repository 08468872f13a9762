// A mirrored scene gives the mirrored picture, and what a material does follows the surface's
// parametrisation.

#include <fmt/format.h>

#include <cmath>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// Direct light of two lights without extent only: no chance but in the pixel's samples, which are
/// the same for all scenes.
std::string Scene(const std::string &world, const std::string &cameraMirror = "",
                  const std::string &film = "rgb") {
    return fmt::format(
        "LookAt .4 .3 4  0 0 0  0 1 0\n{}\nCamera \"perspective\" \"float fov\" 35\n"
        "Film \"{}\" \"integer xresolution\" 24 \"integer yresolution\" 24\nPixelFilter \"box\"\n"
        "Sampler \"independent\" \"integer pixelsamples\" 4\n"
        "Integrator \"path\" \"integer maxdepth\" 1\nWorldBegin\n{}",
        cameraMirror, film, world);
}
constexpr char kLights[] =
    "LightSource \"distant\" \"point3 from\" [ .5 .8 1 ] \"point3 to\" [ 0 0 0 ] \"rgb L\" [ 3 3 3 "
    "]\nLightSource \"point\" \"point3 from\" [ -2 .5 3 ] \"rgb I\" [ 9 6 5 ]\n";

/// Share of values that differ by more than 1e-3 of their size and the mean: local directions are
/// the same but for some ten roundings of 6e-8, which a lobe 0.01 wide makes a hundred times more;
/// the rest is for what lies on an edge.
double ShareThatDiffers(const Image &a, const Image &b) {
    EXPECT_EQ(a.Data().size(), b.Data().size());
    double mean = 0;
    for (const float v : a.Data())
        mean += std::abs(v) / double(a.Data().size());
    EXPECT_GT(mean, 1e-3);
    size_t differ = 0;
    for (size_t i = 0; i < a.Data().size(); ++i)
        differ += !(std::abs(a.Data()[i] - b.Data()[i]) <= 1e-3 * (mean + std::abs(a.Data()[i])));
    return double(differ) / double(a.Data().size());
}
constexpr double kOnEdges = 0.005;

void ExpectSamePicture(const std::string &a, const std::string &b) {
    EXPECT_LE(ShareThatDiffers(RenderText(a), RenderText(b)), kOnEdges) << a << "\nagainst\n" << b;
}

constexpr char kFeather[] =
    "Material \"featherbarbule\" \"float spacing\" 1.6 \"float tilt\" -.5 \"float rotation\" 40\n";
constexpr char kHair[] =
    "Material \"hair\" \"rgb sigma_a\" [ .2 .5 1 ] \"float beta_n\" .2 \"float alpha\" 10\n";

/// Materials that tell one side of dp/du from the other, and those that do not but have a frame.
const std::vector<std::string> kMaterials{
    kFeather,
    "Texture \"r\" \"float\" \"checkerboard\" \"float tex1\" 20 \"float tex2\" -50\n"
    "Material \"featherbarbule\" \"texture rotation\" \"r\"\n",
    kHair,
    "MakeNamedMaterial \"f\" \"string type\" \"featherbarbule\" \"float rotation\" -64\n"
    "MakeNamedMaterial \"h\" \"string type\" \"hair\"\n"
    "Material \"mix\" \"string materials\" [ \"f\" \"h\" ] \"float amount\" 1\n",
    "Material \"conductor\" \"float uroughness\" .4 \"float vroughness\" .1\n",
    "Material \"dielectric\" \"float uroughness\" .2 \"float vroughness\" .5\n",
    "Material \"coateddiffuse\" \"float roughness\" .3\n",
    "Texture \"t\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [ 1 0 0 ] \"rgb tex2\" [ 0 .2 1 ]\n"
    "Material \"diffusetransmission\" \"texture reflectance\" \"t\"\n"};

constexpr char kPatch[] = "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 .3 -1 1 .2 1 1 0 ]\n";
constexpr char kCurve[] =
    "Shape \"curve\" \"string type\" \"{}\" \"point3 P\" [ 1 -.5 0 .3 1 0 -.3 -1 0 -1 .5 0 ] "
    "\"float width\" .7{}\n";
const std::string kRibbon =
    fmt::format(kCurve, "ribbon", " \"normal N\" [ .3 0 1  -.1 .4 1 ]");

const std::vector<std::string> kShapes{
    "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] \"point3 P\" [ -1 -1 0 1 -1 .3 1 1 "
    "0 -1 1 .3 ] \"point2 uv\" [ 0 0 1 0 1 1 0 1 ]\n",
    // Left-handed uv, normals and tangents of its own.
    "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] \"point3 P\" [ -1 -1 0 1 -1 .3 1 1 "
    "0 -1 1 .3 ] \"point2 uv\" [ 1 0 0 0 0 1 1 1 ] \"normal N\" [ -.2 0 1  .2 0 1  .2 .1 1  -.2 .1 "
    "1 ] \"vector3 S\" [ 1 .2 0  1 .3 0  1 0 0  1 -.3 0 ]\n",
    "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 0 1 -1 .3 1 1 0 ]\n",
    kPatch,
    "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 0 -1 1 0 1 1 0 ]\n",
    "ReverseOrientation Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 0 -1 1 0 1 1 0 ] "
    "\"point2 uv\" [ 0 0 0 1 1 0 1 1 ]\n",
    "Rotate 50 1 1 0 Shape \"sphere\"\n",
    "Rotate 50 1 1 0 Shape \"sphere\" \"float zmax\" .4 \"float phimax\" 280\n",
    "Rotate 30 1 1 0 Shape \"disk\" \"float innerradius\" .2\n",
    "Rotate 70 1 1 0 Shape \"cylinder\"\n",
    "ReverseOrientation Rotate 70 1 1 0 Shape \"cylinder\"\n",
    fmt::format(kCurve, "flat", ""),
    fmt::format(kCurve, "cylinder", ""),
    "ReverseOrientation " + fmt::format(kCurve, "cylinder", ""),
    kRibbon};

/// A shape, and an instance of it.
std::vector<std::string> Worlds(const std::string &mirror, const std::string &material,
                                const std::string &shape) {
    return {kLights + material + mirror + shape,
            "ObjectBegin \"o\"\n" + material + shape + "ObjectEnd\n" + kLights + mirror +
                "ObjectInstance \"o\"\n",
            "ObjectBegin \"o\"\n" + material + mirror + shape + "ObjectEnd\n" + kLights +
                "Rotate 20 0 1 0\nObjectInstance \"o\"\n"};
}

class Mirrored : public testing::TestWithParam<std::string> {};

/// The world and the camera by one map: the same picture.
TEST_P(Mirrored, WorldAndCamera) {
    for (const std::string &material : kMaterials)
        for (const std::string &shape : kShapes) {
            const std::string straight = Scene(kLights + material + shape);
            const std::string mirrored =
                Scene(GetParam() + kLights + material + shape, GetParam());
            ExpectSamePicture(straight, mirrored);
        }
}
INSTANTIATE_TEST_SUITE_P(All, Mirrored,
                         testing::Values("Scale -1 1 1\n", "Scale 1 1 -1\n", "Scale -1 -1 -1\n"),
                         [](const auto &info) { return fmt::format("{}", info.index); });

/// An instance is what its shape is under the same transform.
TEST(MirroredInstance, IsTheMirroredShape) {
    for (const std::string &material : kMaterials)
        for (const std::string &shape : kShapes) {
            const auto same = Worlds("Scale -1 1 1\n", material, shape);
            ExpectSamePicture(Scene(same[0]), Scene(same[1]));
            const auto moved = Worlds("Scale 1 -1 1\nRotate 30 0 0 1\n", material, shape);
            ExpectSamePicture(Scene(moved[0]), Scene(moved[1]));
        }
}

}  // namespace
}  // namespace pbrt::test
