#include <fmt/format.h>

#include "pbrt/textures/textures.h"
#include "support/temp_folder.h"
#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

/// Messages of a scene's textures, without the world block's first line.
std::string MessagesOf(const std::string &world) {
    return TextureScene(world, "").Messages();
}

TEST(TextureErrors, UnknownClassNamesTheKnownOnes) {
    EXPECT_EQ(MessagesOf(R"(Texture "a" "float" "chekerboard")"),
              fmt::format("t.pbrt:2:1: unknown texture class \"chekerboard\"; did you mean "
                          "\"checkerboard\"? Known: {}\n",
                          QuotedList(TextureTypes::kNames)));
}

TEST(TextureErrors, UnknownTextureNamesTheNearest) {
    EXPECT_EQ(MessagesOf("Texture \"stripes\" \"float\" \"constant\"\n"
                         "Texture \"b\" \"float\" \"scale\" \"texture tex\" \"strips\""),
              "t.pbrt:3:29: no float texture \"strips\" is defined before its use here; did you "
              "mean \"stripes\"?\n");
}

TEST(TextureErrors, AFloatTextureIsNoSpectrumTexture) {
    EXPECT_EQ(MessagesOf("Texture \"a\" \"float\" \"constant\"\n"
                         "Texture \"b\" \"spectrum\" \"scale\" \"texture tex\" \"a\""),
              "t.pbrt:3:32: \"tex\" wants a spectrum texture, but \"a\" is a float texture\n");
    EXPECT_EQ(MessagesOf("Texture \"a\" \"spectrum\" \"constant\"\n"
                         "Texture \"b\" \"float\" \"scale\" \"texture tex\" \"a\""),
              "t.pbrt:3:29: \"tex\" wants a float texture, but \"a\" is a spectrum texture\n");
}

TEST(TextureErrors, OneMistakeIsOneMessage) {
    // The texture that could not be made stands in for its uses.
    EXPECT_EQ(MessagesOf("Texture \"a\" \"spectrum\" \"marble\"\n"
                         "Texture \"b\" \"spectrum\" \"scale\" \"texture tex\" \"a\""),
              "t.pbrt:2:1: texture class \"marble\": pbrt-v4 has it; not built here. Use "
              "\"imagemap\" with a picture of it\n");
}

TEST(TextureErrors, TexturesOfVeryManyAreRefused) {
    // Each of two of the one before: 2^i look-ups.
    std::string doubled = "Texture \"0\" \"float\" \"checkerboard\"\n";
    for (int i = 1; i <= 20; ++i)
        doubled += fmt::format(
            "Texture \"{}\" \"float\" \"scale\" \"texture tex\" \"{}\" \"texture scale\" \"{}\"\n",
            i, i - 1, i - 1);
    EXPECT_EQ(MessagesOf(doubled).substr(0, 57),  // 2^10 - 1 and itself
              "t.pbrt:11:1: texture \"9\" is made of more than 1000 others");
    std::string nested = "Texture \"0\" \"float\" \"checkerboard\"\n";
    for (int i = 1; i <= 1100; ++i)
        nested += fmt::format(
            "Texture \"{}\" \"float\" \"scale\" \"texture tex\" \"{}\" \"float scale\" 2\n", i,
            i - 1);
    EXPECT_EQ(MessagesOf(nested),
              "t.pbrt:1002:1: texture \"1000\" is made of more than 1000 others\n");
}

TEST(TextureErrors, ParametersAreChecked) {
    EXPECT_EQ(MessagesOf(R"(Texture "a" "float" "checkerboard" "integer dimension" 4)"),
              "t.pbrt:2:56: \"integer dimension\": 4 is outside [2, 3]\n");
    EXPECT_EQ(MessagesOf(R"(Texture "a" "spectrum" "scale" "float scale" -2)"),
              "t.pbrt:2:46: \"float scale\": -2 is less than 0\n");
    EXPECT_EQ(
        MessagesOf(R"(Texture "a" "float" "imagemap")"),
        "t.pbrt:2:1: texture \"imagemap\" needs \"string filename\", a picture's file name\n");
    EXPECT_NE(MessagesOf(R"(Texture "a" "float" "constant" "float valu" 4)")
                  .find("unknown parameter \"float valu\" of texture \"constant\"; did you mean "
                        "\"value\"?"),
              std::string::npos);
    EXPECT_NE(MessagesOf(R"(Texture "a" "float" "imagemap" "string filename" "no-such.png")")
                  .find("no-such.png"),
              std::string::npos);
    EXPECT_NE(MessagesOf(R"(Texture "a" "float" "imagemap" "string filename" "x.png"
                            "string encoding" "gamma two")")
                  .find("unknown encoding \"gamma two\"; expected \"sRGB\", \"linear\" or"),
              std::string::npos);
}

/// Getters as materials use them.
struct Request {
    Request(const std::string &textures, ParsedParameters given) : scene(textures) {
        for (ParsedParameter &p : given)
            p.loc = p.valueLoc = {"m.pbrt", 1, 1};
        params.emplace(std::move(given), FileLoc{"m.pbrt", 1, 1}, "material \"test\"",
                       &RGBColorSpace::sRGB(), &scene.log);
    }
    TextureScene scene;
    std::optional<ParamDict> params;
};

ParsedParameter Texture(std::string name, std::string value) {
    ParsedParameter p;
    p.type = "texture", p.name = std::move(name), p.strings = {std::move(value)};
    return p;
}
ParsedParameter Float(std::string name, float value) {
    ParsedParameter p;
    p.type = "float", p.name = std::move(name), p.floats = {value};
    return p;
}

constexpr FloatParam kRow{"roughness", "", 0.5f, 0, 1, ""};
constexpr SpectrumParam kAlbedo{"reflectance", SpectrumType::Albedo, "0.25", ""};
constexpr SpectrumParam kSigmaA{"sigma_a", SpectrumType::Unbounded, "", ""};

TEST(TextureGetters, TakeTextureConstantOrDefault) {
    Request a(R"(Texture "t" "float" "checkerboard")", {Texture("roughness", "t")});
    EXPECT_FALSE(GetFloatTexture(*a.params, a.scene.named, kRow).IsConstant());
    Request b("", {Float("roughness", 0.25f)});
    EXPECT_EQ(GetFloatTexture(*b.params, b.scene.named, kRow).Constant(), 0.25f);
    Request c("", {});
    EXPECT_EQ(GetFloatTexture(*c.params, c.scene.named, kRow).Constant(), 0.5f);
    EXPECT_FALSE(FindSpectrumTexture(*c.params, c.scene.named, kAlbedo).has_value());
    EXPECT_EQ(GetSpectrumTexture(*c.params, c.scene.named, kAlbedo).Constant()(500), 0.25f);
    EXPECT_EQ(c.scene.Messages(), "");
}

TEST(TextureGetters, CheckTheRangeOfConstantsAndOfConstantTextures) {
    Request a("", {Float("roughness", 2)});
    EXPECT_EQ(GetFloatTexture(*a.params, a.scene.named, kRow).Constant(), 0.5f);
    EXPECT_NE(a.scene.Messages().find("outside [0, 1]"), std::string::npos);
    Request b(R"(Texture "t" "float" "constant" "float value" 3)", {Texture("roughness", "t")});
    EXPECT_EQ(GetFloatTexture(*b.params, b.scene.named, kRow).Constant(), 0.5f);
    EXPECT_EQ(b.scene.Messages(),
              "m.pbrt:1:1: \"roughness\" must lie in [0, 1], but its texture is 3 everywhere\n");
}

TEST(TextureGetters, BrightColoursAreNoAlbedos) {
    Request a(R"(Texture "t" "spectrum" "constant" "rgb value" [ 1 2 3 ])",
              {Texture("reflectance", "t"), Texture("sigma_a", "t")});
    EXPECT_EQ(a.scene.Messages(), "");
    EXPECT_TRUE(FindSpectrumTexture(*a.params, a.scene.named, kSigmaA));
    EXPECT_EQ(a.scene.Messages(), "");
    FindSpectrumTexture(*a.params, a.scene.named, kAlbedo);
    EXPECT_EQ(a.scene.Messages(),
              "m.pbrt:1:1: \"reflectance\" wants values in [0, 1], but texture "
              "\"t\" has RGB values above 1\n");
}

}  // namespace
}  // namespace pbrt::test
