// A mirrored scene gives the mirrored picture, and what a material does follows the surface's
// parametrisation.

#include <fmt/format.h>

#include <cmath>

#include "render/cases.h"
#include "render/render_text.h"
#include "support/folders.h"

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
    EXPECT_GT(mean, 1e-4);
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
    "Material \"featherbarbule\" \"float rotation\" 40 \"float filmroughness\" 10 \"float "
    "cellsacross\" 3 \"float cellsalong\" 4 \"float celltilt\" .1 \"float cellbend\" .2 \"float "
    "cellthickness\" 20\n",
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
    "Material \"diffusetransmission\" \"texture reflectance\" \"t\"\n",
    "Texture \"h\" \"float\" \"imagemap\" \"string filename\" \"" + SourceDir() +
        "/test/render/cases/height.png\" \"float scale\" .2\n"
        "Material \"conductor\" \"float uroughness\" .4 \"float vroughness\" .1 "
        "\"texture displacement\" \"h\"\n",
    "Material \"featherbarbule\" \"float rotation\" 40 \"string normalmap\" \"" + SourceDir() +
        "/test/render/cases/normal.png\"\n"};

constexpr char kPatch[] = "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 .3 -1 1 .2 1 1 0 ]\n";
constexpr char kPoints[] = "1 -.5 0 .3 1 0 -.3 -1 0 -1 .5 0";
std::string Curve(std::string_view type, const std::string &more = "",
                  std::string_view points = kPoints) {
    return fmt::format(
        "Shape \"curve\" \"string type\" \"{}\" \"point3 P\" [ {} ] \"float width\" .5 {}\n", type,
        points, more);
}
const std::string kRibbon = Curve("ribbon", "\"normal N\" [ .3 0 1  -.1 .4 1 ]");

const std::vector<std::string> kShapes{
    "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] \"point3 P\" [ -1 -1 0 1 -1 .3 1 1 "
    "0 -1 1 .3 ] \"point2 uv\" [ 0 0 1 0 1 1 0 1 ]\n",
    // Left-handed uv, normals and tangents of its own.
    "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] \"point3 P\" [ -1 -1 0 1 -1 .3 1 1 "
    "0 -1 1 .3 ] \"point2 uv\" [ 1 0 0 0 0 1 1 1 ] \"normal N\" [ -.2 0 1  .2 0 1  .2 .1 1  -.2 .1 "
    "1 ] \"vector3 S\" [ 1 .2 0  1 .3 0  1 0 0  1 -.3 0 ]\n",
    "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 0 1 -1 .3 1 1 0 ]\n", kPatch,
    "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 0 -1 1 0 1 1 0 ]\n",
    "ReverseOrientation Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 0 -1 1 0 1 1 0 ] "
    "\"point2 uv\" [ 0 0 0 1 1 0 1 1 ]\n",
    "Rotate 50 1 1 0 Shape \"sphere\"\n",
    "Rotate 50 1 1 0 Shape \"sphere\" \"float zmax\" .4 \"float phimax\" 280\n",
    "Rotate 30 1 1 0 Shape \"disk\" \"float innerradius\" .2\n",
    "Rotate 70 1 1 0 Shape \"cylinder\"\n",
    "ReverseOrientation Rotate 70 1 1 0 Shape \"cylinder\"\n", Curve("flat"), Curve("cylinder"),
    "ReverseOrientation " + Curve("cylinder"), kRibbon};

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
            const std::string mirrored = Scene(GetParam() + kLights + material + shape, GetParam());
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

/// The gaps of a mirrored feather dim the light behind it as its mirror image does: shadow rays
/// find the frame by themselves.
TEST_P(Mirrored, LightThroughGaps) {
    const std::string floor = "AttributeBegin\nMaterial \"diffuse\"\nTranslate 0 0 -1\n" +
                              std::string(kPatch) + "AttributeEnd\n";
    const std::string vane =
        "Material \"featherbarbule\" \"float spacing\" 3 \"float tilt\" -.8 \"float rotation\" "
        "40\nTranslate 1 1.5 1\n";
    for (const std::string &shape : kShapes) {
        const std::string world = kLights + floor + vane + shape;
        const Image straight = RenderText(Scene(world));
        const Image mirrored = RenderText(Scene(GetParam() + world, GetParam()));
        EXPECT_LE(ShareThatDiffers(straight, mirrored), kOnEdges) << shape;
    }
}

/// What films keep of the first surface, too.
TEST_P(Mirrored, Albedo) {
    for (const char *material : {kFeather, kHair}) {
        const std::string world = kLights + std::string(material) + kPatch;
        const Image straight = RenderText(Scene(world, "", "gbuffer"));
        const Image mirrored = RenderText(Scene(GetParam() + world, GetParam(), "gbuffer"));
        for (const char *channel :
             {"Albedo.R", "Albedo.G", "Albedo.B", "u", "v", "P.Z", "dzdx", "dzdy"}) {
            const int c = straight.ChannelIndex(channel);
            ASSERT_GE(c, 0);
            for (int i = 0; i < 24; ++i) {
                const float a = straight.Get({i, 12}, c), b = mirrored.Get({i, 12}, c);
                EXPECT_NEAR(a, b, 1e-3f * (std::abs(a) + std::abs(b)) + 1e-5f) << channel;
            }
        }
    }
}

std::string Patch(const std::string &uv) {
    return "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0 1 -1 0 -1 1 0 1 1 0 ] " +
           (uv.empty() ? "" : "\"point2 uv\" [ " + uv + " ]") + "\n";
}
std::string Vane(int rotation, float tilt) {
    return fmt::format(
        "Material \"featherbarbule\" \"float spacing\" 1.6 \"float rotation\" {} \"float tilt\" "
        "{}\n",
        rotation, tilt);
}

/// MODEL section 2: x along dp/du, y on dp/dv's side, whichever way these stand to the normal.
TEST(LeftHandedUV, MirrorTheVane) {
    // u to the left: the barbules' axes turn the other way, and their profile is mirrored in them.
    ExpectSamePicture(Scene(kLights + Vane(40, -.5f) + Patch("1 0 0 0 1 1 0 1")),
                      Scene(kLights + Vane(-40, .5f) + Patch("")));
    // v downwards: the same by half a turn.
    ExpectSamePicture(Scene(kLights + Vane(40, -.5f) + Patch("0 1 1 1 0 0 1 0")),
                      Scene(kLights + Vane(-40, -.5f) + Patch("")));
    // u and v exchanged: y is the old x.
    ExpectSamePicture(Scene(kLights + Vane(40, -.5f) + Patch("0 0 0 1 1 0 1 1")),
                      Scene(kLights + Vane(50, -.5f) + Patch("")));
}

TEST(ReverseOrientation, TurnsTheVaneOverButNotItsBarbules) {
    ExpectSamePicture(Scene(kLights + Vane(40, -.5f) + "ReverseOrientation\n" + Patch("")),
                      Scene(kLights + Vane(40, .5f) + Patch("")));
}

/// A fibre has no sides: neither the outside nor the sense of v matters, from either side.
TEST(Fibres, LookTheSameFromAllSides) {
    const std::string material = kLights + std::string(kHair);
    const std::string straight = Scene(material + Patch(""));
    const auto expectSame = [&](const std::string &shape) {
        ExpectSamePicture(straight, Scene(material + shape));
    };
    expectSame("ReverseOrientation\n" + Patch(""));
    expectSame(Patch("0 1 1 1 0 0 1 0"));
    expectSame("ReverseOrientation\n" + Patch("0 1 1 1 0 0 1 0"));
    expectSame("Rotate 180 1 0 0\n" + Patch(""));
    for (const std::string type : {"flat", "cylinder"}) {
        const std::string scene = Scene(material + Curve(type));
        ExpectSamePicture(scene, Scene(material + "ReverseOrientation\n" + Curve(type)));
        ExpectSamePicture(Scene(material + "Scale -1 1 1\n" + Curve(type)),
                          Scene(material + Curve(type, "", "-1 -.5 0 -.3 1 0 .3 -1 0 1 .5 0")));
    }
    // Flat, for the two triangles of a bent quad are others where v is turned round.
    const std::string points = "-1 -.3 0 -.3 -.1 0 .3 .1 0 1 .3 0";
    ExpectSamePicture(Scene(material + Curve("ribbon", "\"normal N\" [ 0 0 1 0 0 1 ]", points)),
                      Scene(material + Curve("ribbon", "\"normal N\" [ 0 0 -1 0 0 -1 ]", points)));
}

std::string Without(std::string text, const std::string &part) {
    for (size_t at; (at = text.find("\n" + part + "\n")) != text.npos;)
        text.erase(at + 1, part.size() + 1);
    return text;
}

TEST(Cases, FeatherMirrored) {
    const std::string mirrored = Case("feather-mirrored.pbrt");
    ExpectSamePicture(mirrored, Without(mirrored, "Scale -1 1 1"));
}

TEST(Cases, HairMirroredInstance) {
    const std::string instance = Case("hair-mirrored-instance.pbrt");
    std::string shape = Without(instance, "Scale -1 1 1");
    shape.insert(shape.find("Shape \"curve\""), "Scale -1 1 1\n");
    ExpectSamePicture(instance, shape);
}

}  // namespace
}  // namespace pbrt::test
