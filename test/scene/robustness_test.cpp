// Damaged scenes never crash the parser, and messages stay inside the text.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scene/parse.h"

namespace pbrt {
namespace {

constexpr std::string_view kScene = R"(# every kind of directive
Option "seed" 3 LookAt 0 0 5 0 0 0 0 1 0 Camera "perspective" "float fov" [ 40 ]
Film "rgb" "integer xresolution" [ 64 ] "bool savefp16" true "string filename" "a\\b.exr"
ColorSpace "srgb" TransformTimes 0 1 WorldBegin
Attribute "shape" "float alpha" [ 1 ]
AttributeBegin Translate 1 2 3 Texture "t" "float" "constant" "float value" 0.5
  ActiveTransform EndTime Rotate 30 0 0 1 ActiveTransform All
  MakeNamedMaterial "m" "string type" "diffuse" "rgb reflectance" [ 0.1 0.2 0.3 ]
  NamedMaterial "m" Shape "trianglemesh" "integer indices" [ 0 1 2 ]
    "point3 P" [ 0 0 0  1 0 0  0 1e0 0x1p-1 ]
AttributeEnd
ObjectBegin "o" ConcatTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ] Shape "sphere" ObjectEnd
ObjectInstance "o" CoordinateSystem "c" CoordSysTransform "c" ReverseOrientation
MediumInterface "" "" AreaLightSource "diffuse" "spectrum L" [ 400 1 500 2 ] Shape "disk"
LightSource "point" "blackbody I" 3000 Material "conductor" "spectrum eta" "metal-Cu-eta"
)";

/// One to three bytes or stretches changed, lost, repeated or moved.
std::string Damaged(std::mt19937 &random) {
    std::string text(kScene);
    const auto below = [&](size_t n) { return random() % n; };
    constexpr std::string_view kBytes = "\"[]# \n\\0-.ex\t\xC3\xA4\r";
    for (size_t i = 1 + below(3); i-- > 0 && !text.empty();) {
        const size_t at = below(text.size()), length = 1 + below(12);
        switch (below(4)) {
            case 0:
                text[at] = kBytes[below(kBytes.size())];
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(below(text.size()), text.substr(at, length));
                break;
            case 3:
                text.resize(std::max<size_t>(1, at));
                break;
        }
    }
    return text;
}

TEST(Robustness, DamagedScenesAreReadOrReported) {
    const auto whole = Parse(kScene);
    EXPECT_EQ(whole->Messages(), Texts{});
    EXPECT_EQ(whole->scene.shapes.size(), 2u);
    std::mt19937 random(3);
    for (int i = 0; i < 4000; ++i) {
        const std::string text = Damaged(random);
        const auto parsed = Parse(text);
        const int lines = int(std::count(text.begin(), text.end(), '\n')) + 1;
        for (const std::string &m : parsed->Messages()) {
            if (m == "test.pbrt: the scene ends without WorldBegin") continue;
            int line = 0, column = 0;
            ASSERT_EQ(std::sscanf(m.c_str(), "test.pbrt:%d:%d: ", &line, &column), 2) << m << text;
            ASSERT_TRUE(line >= 1 && line <= lines && column >= 1) << m << text;
        }
    }
}

TEST(Robustness, OneMistakeGivesFewMessages) {
    // A lost byte is one mistake; what follows from it stays small. The worst is a lost blank
    // between AttributeEnd and ObjectBegin: an unknown directive, three scopes that no longer
    // match, two names that are then undefined.
    for (size_t at = 0; at < kScene.size(); ++at) {
        std::string text(kScene);
        text.erase(at, 1);
        EXPECT_LE(Parse(text)->Messages().size(), 6u) << at << '\n' << text;
    }
}

}  // namespace
}  // namespace pbrt
