#include "pbrt/image/image.h"
#include "pbrt/textures/mipmap.h"
#include "support/exr_parts.h"
#include "support/temp_folder.h"
#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

using ImageTextures = TempFolder;
const SampledWavelengths kLambda = SampledWavelengths::SampleVisible(0.7f);

/// 2 x 2 texels, rows from the top.
void WriteQuad(const std::string &path, const std::vector<RGB> &texels,
               const RGBColorSpace *space = nullptr) {
    Image image({2, 2}, {"R", "G", "B"});
    for (int i = 0; i < 4; ++i)
        for (int c = 0; c < 3; ++c)
            image.Set({i % 2, i / 2}, c, texels[size_t(i)][c]);
    if (space) image.metadata.chromaticities = space->Chromaticities();
    EXPECT_EQ(WriteImage(image, path, ExrPixels::Float), std::nullopt);
}

const std::vector<RGB> kTexels{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {.2f, .4f, .9f}};

TEST_F(ImageTextures, StandUprightInUV) {
    WriteQuad(Path("a.exr"), kTexels);
    const TextureScene s(R"(
        Texture "f" "float" "imagemap" "string filename" "a.exr" "string filter" "point"
    )",
                         folder.string());
    EXPECT_FLOAT_EQ(s.Float("f").Evaluate(AtUV(0.75f, 0.25f)), 0.5f);  // right below
    EXPECT_FLOAT_EQ(s.Float("f").Evaluate(AtUV(0.25f, 0.75f)), 1 / 3.f);
}

TEST_F(ImageTextures, BecomeSpectraByRole) {
    WriteQuad(Path("a.exr"), kTexels);
    const TextureScene s(R"(
        Texture "t" "spectrum" "imagemap" "string filename" "a.exr" "string filter" "point"
    )",
                         folder.string());
    const RGBColorSpace &space = RGBColorSpace::sRGB();
    const TextureEvalContext at = AtUV(0.75f, 0.25f);
    const RGB c = kTexels[3];
    const auto got = [&](SpectrumType role) { return s.Spectrum("t", role).Evaluate(at, kLambda); };
    for (int i = 0; i < NSpectrumSamples; ++i) {
        EXPECT_EQ(got(SpectrumType::Albedo)[i], space.SampleAlbedo(c, kLambda)[i]);
        EXPECT_EQ(got(SpectrumType::Unbounded)[i], space.SampleUnbounded(c, kLambda)[i]);
        EXPECT_EQ(got(SpectrumType::Illuminant)[i], space.SampleIlluminant(c, kLambda)[i]);
    }
}

TEST_F(ImageTextures, UseThePicturesPrimaries) {
    const RGBColorSpace &aces = *RGBColorSpace::Named("aces2065-1");
    WriteQuad(Path("a.exr"), kTexels, &aces);
    const TextureScene s(R"(
        Texture "t" "spectrum" "imagemap" "string filename" "a.exr" "string filter" "point"
    )",
                         folder.string());
    const SampledSpectrum got =
        s.Spectrum("t", SpectrumType::Albedo).Evaluate(AtUV(0.75f, 0.25f), kLambda);
    for (int i = 0; i < NSpectrumSamples; ++i)
        EXPECT_EQ(got[i], aces.SampleAlbedo(kTexels[3], kLambda)[i]);
}

TEST_F(ImageTextures, ScaleThenInvertThenLimit) {
    WriteQuad(Path("a.exr"), std::vector<RGB>(4, {.4f, .4f, .4f}));
    const TextureScene s(R"(
        Texture "s" "float" "imagemap" "string filename" "a.exr" "float scale" 2
        Texture "i" "float" "imagemap" "string filename" "a.exr" "float scale" 2 "bool invert" true
        Texture "b" "float" "imagemap" "string filename" "a.exr" "float scale" 3 "bool invert" true
        Texture "t" "spectrum" "imagemap" "string filename" "a.exr" "float scale" 5
    )",
                         folder.string());
    EXPECT_FLOAT_EQ(s.Float("s").Evaluate(AtUV(0, 0)), 0.8f);
    EXPECT_NEAR(s.Float("i").Evaluate(AtUV(0, 0)), 0.2f, 1e-6);
    EXPECT_EQ(s.Float("b").Evaluate(AtUV(0, 0)), 0);
    EXPECT_EQ(s.Spectrum("t", SpectrumType::Albedo).Evaluate(AtUV(0, 0), kLambda)[0], 1);
    EXPECT_FLOAT_EQ(s.Spectrum("t", SpectrumType::Unbounded).Evaluate(AtUV(0, 0), kLambda)[0], 2);
}

TEST_F(ImageTextures, DecodeAsAsked) {
    WriteQuad(Path("a.png"), std::vector<RGB>(4, {.5f, .5f, .5f}));
    const TextureScene s(R"(
        Texture "d" "float" "imagemap" "string filename" "a.png"
        Texture "l" "float" "imagemap" "string filename" "a.png" "string encoding" "linear"
        Texture "g" "float" "imagemap" "string filename" "a.png" "string encoding" "gamma 2"
    )",
                         folder.string());
    const float code = 188.f / 255;  // sRGB code of 0.5
    EXPECT_NEAR(s.Float("d").Evaluate(AtUV(0, 0)), 0.5, 0.003);
    EXPECT_NEAR(s.Float("l").Evaluate(AtUV(0, 0)), code, 1e-6);
    EXPECT_NEAR(s.Float("g").Evaluate(AtUV(0, 0)), code * code, 1e-6);
    EXPECT_EQ(s.named.images.size(), 3u);
    for (const auto &[name, map] : s.named.images)
        EXPECT_LT(map->MemoryBytes(), 4 * 3 * sizeof(float)) << name;  // bytes
}

TEST_F(ImageTextures, ShareOnePicture) {
    WriteQuad(Path("a.exr"), kTexels);
    const TextureScene s(R"(
        Texture "a" "float" "imagemap" "string filename" "a.exr"
        Texture "b" "spectrum" "imagemap" "string filename" "a.exr" "string wrap" "clamp"
    )",
                         folder.string());
    EXPECT_EQ(s.Messages(), "");
    EXPECT_EQ(s.named.images.size(), 1u);
}

/// 2 x 1 texels of red (1, 0.25, 0.25) and alpha 51 / 255 and 1.
Image SeeThrough(std::vector<std::string> channels = {"R", "G", "B", "A"}) {
    Image image({2, 1}, std::move(channels));
    for (int x = 0; x < 2; ++x)
        for (int c = 0; c < image.NChannels(); ++c)
            image.Set({x, 0}, c, c == 0 ? 1 : 0.25f);
    for (int x = 0; x < 2; ++x)
        image.Set({x, 0}, image.NChannels() - 1, x == 0 ? 51 / 255.f : 1);
    return image;
}

TEST_F(ImageTextures, FloatsAreAlphaWhereThePictureHasIt) {
    for (const std::string name : {"a.png", "a.exr"})
        for (const ExrPixels pixels : {ExrPixels::Half, ExrPixels::Float}) {
            ASSERT_EQ(WriteImage(SeeThrough(), Path(name), pixels), std::nullopt);
            const TextureScene s("Texture \"c\" \"spectrum\" \"imagemap\" \"string filename\" \"" +
                                     name + "\" \"string filter\" \"point\"\n" +
                                     "Texture \"a\" \"float\" \"imagemap\" \"string filename\" \"" +
                                     name + "\" \"string filter\" \"point\"\n" +
                                     "Texture \"i\" \"float\" \"imagemap\" \"string filename\" \"" +
                                     name + "\" \"bool invert\" true \"float scale\" .5\n",
                                 folder.string());
            // Half has 11 bits.
            EXPECT_NEAR(s.Float("a").Evaluate(AtUV(0.25f, 0.5f)), 0.2f, 0.2f * 0x1p-11f);
            EXPECT_EQ(s.Float("a").Evaluate(AtUV(0.75f, 0.5f)), 1);
            EXPECT_NEAR(s.Float("i").Evaluate(AtUV(0.25f, 0.5f)), 0.9f, 1e-4f);
            EXPECT_EQ(s.named.images.size(), 2u);
            // Colour stays what it is.
            const SampledSpectrum red =
                s.Spectrum("c", SpectrumType::Albedo).Evaluate(AtUV(0.25f, 0.5f), kLambda);
            const RGB c{1, 0.25f, 0.25f};
            for (int i = 0; i < NSpectrumSamples; ++i)
                EXPECT_NEAR(red[i], RGBColorSpace::sRGB().SampleAlbedo(c, kLambda)[i], 5e-3f);
        }
}

TEST_F(ImageTextures, AlphaIsLinearWhateverTheEncoding) {
    ASSERT_EQ(WriteImage(SeeThrough(), Path("a.png")), std::nullopt);
    for (const std::string encoding : {"sRGB", "linear", "gamma 2.2"}) {
        const TextureScene s(
            "Texture \"a\" \"float\" \"imagemap\" \"string filename\" \"a.png\" "
            "\"string filter\" \"point\" \"string encoding\" \"" +
                encoding + "\"",
            folder.string());
        EXPECT_EQ(s.Float("a").Evaluate(AtUV(0.25f, 0.5f)), 51 / 255.f) << encoding;
    }
}

TEST_F(ImageTextures, FloatsAreTheMeanWhereAlphaSaysNothing) {
    Image image = SeeThrough();
    image.Set({0, 0}, 3, 1);
    ASSERT_EQ(WriteImage(image, Path("opaque.exr"), ExrPixels::Float), std::nullopt);
    ASSERT_EQ(WriteImage(SeeThrough({"Y", "A"}), Path("gray.exr"), ExrPixels::Float), std::nullopt);
    const TextureScene s(R"(
        Texture "o" "float" "imagemap" "string filename" "opaque.exr"
        Texture "c" "spectrum" "imagemap" "string filename" "opaque.exr"
        Texture "g" "float" "imagemap" "string filename" "gray.exr"
    )",
                         folder.string());
    EXPECT_FLOAT_EQ(s.Float("o").Evaluate(AtUV(0.25f, 0.5f)), 0.5f);
    EXPECT_EQ(s.Float("g").Evaluate(AtUV(0.25f, 0.5f)), 1);  // pbrt-v4 reads Y
    EXPECT_EQ(s.named.images.size(), 2u);
}

TEST_F(ImageTextures, AlphaAloneIsOneChannel) {
    ASSERT_EQ(WriteImage(SeeThrough(), Path("a.png")), std::nullopt);
    const TextureScene s(R"(
        Texture "a" "float" "imagemap" "string filename" "a.png"
        Texture "b" "float" "imagemap" "string filename" "a.png" "string filter" "ewa"
    )",
                         folder.string());
    EXPECT_EQ(s.Messages(), "");
    ASSERT_EQ(s.named.images.size(), 1u);
    EXPECT_EQ(s.named.images.begin()->second->NChannels(), 1);
}

TEST_F(ImageTextures, WarnOnceOfPartsThatAreNotRead) {
    WriteExrParts(Path("a.exr"), {"left", "right"}, {2, 2});
    const TextureScene s(R"(
        Texture "a" "float" "imagemap" "string filename" "a.exr"
        Texture "b" "spectrum" "imagemap" "string filename" "a.exr" "string encoding" "linear"
    )",
                         folder.string());
    EXPECT_EQ(s.Messages(),
              "t.pbrt:3:40: " + Path("a.exr") +
                  ": has 2 parts, of which only the first, \"left\", is read (others: "
                  "\"right\")\n");
    EXPECT_EQ(s.named.floats.at("a").Evaluate(AtUV(0.5f, 0.5f)), 1);
}

TEST_F(ImageTextures, NoteWhoLooksAtUV) {
    WriteQuad(Path("a.exr"), kTexels);
    const TextureScene s(R"(
        Texture "a" "float" "imagemap" "string filename" "a.exr"
        Texture "p" "float" "imagemap" "string filename" "a.exr" "string mapping" "planar"
        Texture "c" "spectrum" "checkerboard"
        Texture "cubes" "spectrum" "checkerboard" "integer dimension" 3
        Texture "s" "float" "scale" "texture scale" "a"
        Texture "m" "spectrum" "mix" "texture tex1" "c"
        Texture "n" "spectrum" "mix" "texture tex1" "cubes"
    )",
                         folder.string());
    EXPECT_EQ(s.Messages(), "");
    EXPECT_EQ(s.named.readUV, (std::set<std::string>{"a", "c", "s", "m"}));
}

TEST_F(ImageTextures, PassTheFootprintOn) {
    Image image({8, 8}, {"Y"});
    image.Set({3, 3}, 0, 64);
    ASSERT_EQ(WriteImage(image, Path("a.exr"), ExrPixels::Float), std::nullopt);
    const TextureScene s(R"(
        Texture "point" "float" "imagemap" "string filename" "a.exr" "string filter" "point"
        Texture "bilinear" "float" "imagemap" "string filename" "a.exr"
        Texture "trilinear" "float" "imagemap" "string filename" "a.exr" "string filter" "trilinear"
        Texture "ewa" "float" "imagemap" "string filename" "a.exr" "string filter" "ewa"
    )",
                         folder.string());
    EXPECT_TRUE(s.named.readFootprints);
    for (const std::string filter : {"point", "bilinear", "trilinear", "ewa"}) {
        TextureEvalContext ctx = AtUV(0.1f, 0.1f);
        EXPECT_EQ(s.Float(filter).Evaluate(ctx), 0) << filter;
        ctx.dudx = ctx.dvdy = 1;
        EXPECT_NEAR(s.Float(filter).Evaluate(ctx), 1, 1e-5) << filter;
    }
}

}  // namespace
}  // namespace pbrt::test
