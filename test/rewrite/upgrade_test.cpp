// `pbrt --upgrade`: small scenes of pbrt-v3, and what a hand makes of them for pbrt-v4.

#include "render/render_text.h"
#include "rewrite/rewriting.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

std::string Upgraded(const std::string &text, const std::string &messages = "") {
    const Rewritten r = Rewrite(text, rewrite::Task::Upgrade);
    EXPECT_EQ(r.messages, messages);
    EXPECT_NE(r.text, "") << text;
    return r.text;
}

/// Both scenes give the same bits.
void ExpectSamePicture(const std::string &text, const std::string &byHand,
                       const std::string &dir = ".") {
    const Image a = RenderText(text, {.spp = 4}, dir), b = RenderText(byHand, {.spp = 4}, dir);
    EXPECT_TRUE(std::ranges::equal(a.Data(), b.Data())) << text;
}

constexpr char kOldHead[] = R"(Film "image" "integer xresolution" 16 "integer yresolution" 12
Camera "perspective" "float fov" 50
WorldBegin
LightSource "point" "point from" [ 1 2 -1 ] "color I" [ 9 8 7 ] "color scale" [ 2 2 2 ]
LightSource "infinite" "integer samples" 4 "rgb L" [ .3 .4 .5 ]
Translate 0 0 3
)";
constexpr char kNewHead[] = R"(Film "rgb" "integer xresolution" 16 "integer yresolution" 12
Camera "perspective" "float fov" 50
WorldBegin
LightSource "point" "point3 from" [ 1 2 -1 ] "rgb I" [ 9 8 7 ] "float scale" 2
LightSource "infinite" "rgb L" [ .3 .4 .5 ]
Translate 0 0 3
)";

/// A ball of a material on a ground, or what else goes into the world.
struct Case {
    const char *was, *is, *messages = "";
};

class Worlds : public testing::TestWithParam<Case> {};

TEST_P(Worlds, RenderAsTheirTwinsOfPbrtV4) {
    const Case &c = GetParam();
    const std::string ball = "\nShape \"sphere\"\n";
    ExpectSamePicture(Upgraded(kOldHead + (c.was + ball) + "WorldEnd\n", c.messages),
                      kNewHead + (c.is + ball));
}

const Case kCases[] = {
    {R"(Material "matte" "color Kd" [ .5 .2 .1 ] "float sigma" 0)",
     R"(Material "diffuse" "rgb reflectance" [ .5 .2 .1 ])"},
    {R"(Material "plastic" "rgb Kd" [ .5 .2 .1 ] "rgb Ks" [ .3 .3 .3 ] "float roughness" .1)",
     R"(Material "coateddiffuse" "rgb reflectance" [ .5 .2 .1 ] "float roughness" .1)",
     "test.pbrt:7:42: \"rgb Ks\" is left out: pbrt-v4 has no such parameter\n"},
    {R"(Material "uber" "rgb Kd" [ .5 .2 .1 ] "rgb Ks" [ 0 0 0 ] "rgb opacity" [ 1 1 1 ])",
     R"(Material "diffuse" "rgb reflectance" [ .5 .2 .1 ])"},
    {R"(Material "uber" "rgb Kd" [ .5 .2 .1 ] "float index" 1.7)",
     R"(Material "coateddiffuse" "rgb reflectance" [ .5 .2 .1 ] "float eta" 1.7)"},
    {R"(Material "substrate" "rgb Kd" [ .5 .2 .1 ] "float uroughness" .1 "float vroughness" .2)",
     R"(Material "coateddiffuse" "rgb reflectance" [ .5 .2 .1 ]
        "float uroughness" .1 "float vroughness" .2)"},
    {R"(Material "glass" "rgb Kr" [ 1 1 1 ] "rgb Kt" [ 1 1 1 ] "float index" 1.3)",
     R"(Material "dielectric" "float eta" 1.3)"},
    {R"(Material "metal" "float roughness" .05 "bool remaproughness" "false")",
     R"(Material "conductor" "float roughness" .05 "bool remaproughness" false)"},
    {R"(Material "mirror")",
     R"(Material "conductor" "float roughness" 0 "spectrum eta" "metal-Ag-eta"
        "spectrum k" "metal-Ag-k")"},
    {R"(Material "translucent" "rgb Kd" [ .8 .6 .4 ])",
     R"(Material "diffusetransmission" "rgb reflectance" [ .8 .6 .4 ]
        "rgb transmittance" [ .8 .6 .4 ] "float scale" .5)"},
    {R"(Material "translucent" "rgb Kd" [ .8 .6 .4 ] "rgb reflect" [ 0 0 0 ] "rgb transmit" [ 1 1 1 ])",
     R"(Material "diffusetransmission" "rgb reflectance" [ 0 0 0 ]
        "rgb transmittance" [ .8 .6 .4 ])"},
    {R"(Material "disney" "color color" [ .5 .2 .1 ] "float metallic" 0)",
     R"(Material "diffuse" "rgb reflectance" [ .5 .2 .1 ])"},
    {R"(Material "none")", R"(Material "interface")"},
    {R"(MakeNamedMaterial "a" "string type" "matte" "rgb Kd" [ .5 .2 .1 ]
        MakeNamedMaterial "b" "string type" "metal" "float roughness" .1
        Material "mix" "rgb amount" [ .3 .3 .3 ] "string namedmaterial1" "a"
          "string namedmaterial2" "b")",
     R"(MakeNamedMaterial "a" "string type" "diffuse" "rgb reflectance" [ .5 .2 .1 ]
        MakeNamedMaterial "b" "string type" "conductor" "float roughness" .1
        Material "mix" "float amount" .3 "string materials" [ "b" "a" ])"},
    {R"(Texture "t" "color" "checkerboard" "color tex1" [ .8 .1 .1 ] "color tex2" [ .1 .1 .8 ]
          "float uscale" 4 "float vscale" 4 "string aamode" "none"
        Texture "s" "color" "scale" "texture tex1" "t" "color tex2" [ .5 .5 .5 ]
        Texture "b" "float" "fbm"
        Texture "c" "float" "scale" "texture tex1" "b" "float tex2" .1
        Material "matte" "texture Kd" "s" "texture bumpmap" "c")",
     R"(Texture "t" "spectrum" "checkerboard" "rgb tex1" [ .8 .1 .1 ] "rgb tex2" [ .1 .1 .8 ]
          "float uscale" 4 "float vscale" 4
        Texture "s" "spectrum" "scale" "texture tex" "t" "float scale" .5
        Texture "b" "float" "fbm"
        Texture "c" "float" "scale" "texture tex" "b" "float scale" .1
        Material "diffuse" "texture reflectance" "s" "texture displacement" "c")"},
    {R"(AttributeBegin
          AreaLightSource "area" "blackbody L" [ 3000 2 ] "rgb scale" [ .5 .5 .5 ]
            "integer nsamples" 4
          Shape "trianglemesh" "point P" [ -3 2 0  3 2 0  0 2 3 ] "integer indices" [ 0 1 2 ]
            "float st" [ 0 0 1 0 0 1 ] "bool discarddegenerateUVs" "true"
        AttributeEnd)",
     R"(AttributeBegin
          AreaLightSource "diffuse" "blackbody L" 3000
          Shape "trianglemesh" "point3 P" [ -3 2 0  3 2 0  0 2 3 ] "integer indices" [ 0 1 2 ]
            "point2 uv" [ 0 0 1 0 0 1 ]
        AttributeEnd)"},
    {R"(Texture "t" "color" "constant" "rgb value" [ .9 .1 .1 ]
        AttributeBegin
          Texture "t" "color" "constant" "rgb value" [ .1 .9 .1 ]
          Material "matte" "texture Kd" "t" Translate 1 0 0 Shape "disk"
        AttributeEnd
        Material "matte" "texture Kd" "t")",
     R"(Texture "red" "spectrum" "constant" "rgb value" [ .9 .1 .1 ]
        Texture "green" "spectrum" "constant" "rgb value" [ .1 .9 .1 ]
        AttributeBegin
          Material "diffuse" "texture reflectance" "green" Translate 1 0 0 Shape "disk"
        AttributeEnd
        Material "diffuse" "texture reflectance" "red")",
     "test.pbrt:9:11: spectrum texture \"t\" is defined before; here it becomes \"t-2\"\n"},
    {R"(TransformBegin Translate 1 0 0 Shape "disk" TransformEnd
        ObjectBegin "o" Shape "disk" ObjectEnd
        ObjectInstance "o")",
     R"(AttributeBegin Translate 1 0 0 Shape "disk" AttributeEnd
        ObjectBegin "o" Shape "disk" ObjectEnd
        ObjectInstance "o")"},
    {R"(Shape "loopsubdiv" "integer nlevels" 2 "integer indices" [ 0 1 2  0 2 3  0 3 1  1 3 2 ]
          "point P" [ 0 0 1  1 0 0  -1 1 0  -1 -1 0 ])",
     R"(Shape "loopsubdiv" "integer levels" 2 "integer indices" [ 0 1 2  0 2 3  0 3 1  1 3 2 ]
          "point3 P" [ 0 0 1  1 0 0  -1 1 0  -1 -1 0 ])"},
};
INSTANTIATE_TEST_SUITE_P(Upgrade, Worlds, testing::ValuesIn(kCases));

TEST(Upgrade, SettingsOfTheImage) {
    const std::string world =
        "\nWorldBegin\nLightSource \"infinite\"\nTranslate 0 0 3\n"
        "Shape \"sphere\"\n";
    const std::string size = "\"integer xresolution\" 12 \"integer yresolution\" 12 ";
    const auto same = [&](const std::string &was, const std::string &is) {
        ExpectSamePicture(Upgraded(was + world), is + world);
    };
    same("Film \"image\" " + size + "\"float scale\" 2 \"float maxsampleluminance\" 1\n",
         "Film \"rgb\" " + size + "\"float iso\" 200 \"float maxcomponentvalue\" 1\n");
    const std::string film = "Film \"rgb\" " + size;
    same(film + "PixelFilter \"gaussian\" \"float xwidth\" 2 \"float ywidth\" 3 \"float alpha\" 2",
         film +
             "PixelFilter \"gaussian\" \"float xradius\" 2 \"float yradius\" 3 "
             "\"float sigma\" .5");
    same(film + "Camera \"environment\"",
         film + "Camera \"spherical\" \"string mapping\" \"equirectangular\"");
    same(film + "Integrator \"directlighting\" \"string strategy\" \"all\"",
         film + "Integrator \"path\" \"integer maxdepth\" 1");
    same(film +
             "SurfaceIntegrator \"path\" \"integer maxdepth\" 3 \"float rrthreshold\" .1 "
             "\"string lightsamplestrategy\" \"spatial\"",
         film + "Integrator \"path\" \"integer maxdepth\" 3 \"string lightsampler\" \"bvh\"");
    for (const auto &[was, is] : {std::pair("02sequence", "paddedsobol"),
                                  {"lowdiscrepancy", "paddedsobol"},
                                  {"maxmindist", "pmj02bn"},
                                  {"random", "independent"},
                                  {"halton", "halton"}})
        same(film + "Sampler \"" + was + "\" \"integer pixelsamples\" 4 \"integer dimensions\" 4",
             film + "Sampler \"" + is + "\" \"integer pixelsamples\" 4");
}

TEST(Upgrade, WhatHasNoLikeIsToldWithItsPlace) {
    const auto says = [](const std::string &text) {
        const Rewritten r = Rewrite(text, rewrite::Task::Upgrade);
        EXPECT_EQ(r.text, "") << text;
        return r.messages;
    };
    EXPECT_EQ(says("Material \"fourier\" \"string bsdffile\" \"a.bsdf\""),
              "test.pbrt:1:1: material \"fourier\" has no like in pbrt-v4; write another\n");
    EXPECT_EQ(says("Material \"uber\" \"texture opacity\" \"t\""),
              "test.pbrt:1:17: pbrt-v4 has no \"opacity\" of materials: give the shapes an "
              "\"alpha\", and leave it out here\n");
    EXPECT_EQ(says("LightSource \"point\" \"rgb scale\" [ 1 2 3 ]"),
              "test.pbrt:1:21: the \"scale\" of lights is a number in pbrt-v4: multiply \"L\" or "
              "\"I\" by this color\n");
    EXPECT_EQ(says("Texture \"t\" \"color\" \"scale\" \"texture tex1\" \"a\" \"texture tex2\" "
                   "\"b\""),
              "test.pbrt:1:1: pbrt-v4 multiplies a texture of colors by a number only, and neither "
              "\"tex1\" nor \"tex2\" is gray\n");
}

TEST(Upgrade, WhatHoldsLongerInPbrtV3IsWarnedOf) {
    EXPECT_EQ(Rewrite("TransformBegin\nMaterial \"matte\"\nTransformEnd", rewrite::Task::Upgrade)
                  .messages,
              "test.pbrt:2:1: Material inside of TransformBegin: in pbrt-v3 it holds beyond "
              "TransformEnd, in pbrt-v4 not; repeat it there\n");
    EXPECT_EQ(Rewrite("Include \"a\"\nInclude \"b\"", rewrite::Task::Upgrade).messages,
              "test.pbrt:1:1: files of Include and Import stay as they are; where they are of "
              "pbrt-v3, upgrade each by itself\n");
}

TEST(Upgrade, TextsThatEndAnywhere) {
    for (const Case &c : kCases) {
        const std::string text = kOldHead + std::string(c.was);
        for (size_t n = 0; n < text.size(); ++n)
            for (const auto task :
                 {rewrite::Task::Format, rewrite::Task::ToPly, rewrite::Task::Upgrade}) {
                const Rewritten r = Rewrite(text.substr(0, n), task);
                EXPECT_TRUE(!r.text.empty() || !r.messages.empty() || n == 0);
            }
    }
}

TEST(Upgrade, ScenesOfPbrtV4Stay) {
    const std::string text = Formatted(R"(Film "rgb" "float iso" 50
WorldBegin
Texture "t" "spectrum" "scale" "texture tex" "u" "float scale" .5
Texture "v" "spectrum" "imagemap" "string filename" "a.png" "string filter" "ewa"
LightSource "infinite" "rgb L" [ 1 1 1 ] "float scale" 2
Material "coateddiffuse" "rgb reflectance" [ 1 0 0 ] "float roughness" 0.1
Material "mix" "string materials" [ "a" "b" ] "float amount" 0.2
AreaLightSource "diffuse" "rgb L" [ 1 1 1 ] "bool twosided" true
Shape "trianglemesh" "point2 uv" [ 0 0 1 0 1 1 ]
)");
    EXPECT_EQ(Upgraded(text), text);
}

}  // namespace
}  // namespace pbrt::test
