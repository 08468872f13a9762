#include <cmath>

#include "pbrt/ptex/texture.h"
#include "support/temp_folder.h"
#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

const SampledWavelengths kLambda = SampledWavelengths::SampleVisible(0.3f);

TextureEvalContext AtFace(int face, Point2f uv = {0.5f, 0.5f}) {
    TextureEvalContext ctx = AtUV(uv.x, uv.y);
    ctx.faceIndex = face;
    return ctx;
}

class PerFace : public TempFolder {
  protected:
    /// A texture "t" of class ptex that reads `content`.
    TextureScene Scene(const PtexContent &content, const std::string &kind,
                       const std::string &parameters) const {
        EXPECT_EQ(WritePtex(Path("a.ptx"), content), std::nullopt);
        return TextureScene(
            "Texture \"t\" \"" + kind + "\" \"ptex\" \"string filename\" \"a.ptx\" " + parameters,
            folder.string());
    }
};

TEST_F(PerFace, FloatsAreDecodedAndScaled) {
    const std::vector<float> values{0.25f, -0.3f, 600};
    const PtexContent content = ConstantPtex(1, values);
    const TextureScene linear =
        Scene(content, "float", R"("string encoding" "linear" "float scale" 2)");
    const TextureScene gamma = Scene(content, "float", "");
    for (int face = 0; face < 3; ++face) {
        const float v = values[size_t(face)];
        EXPECT_EQ(linear.Float("t").Evaluate(AtFace(face)), 2 * v);
        EXPECT_EQ(gamma.Float("t").Evaluate(AtFace(face)), std::pow(std::max(v, 0.f), 2.2f));
    }
    EXPECT_EQ(linear.Float("t").Evaluate(AtFace(3)), 0);
    EXPECT_EQ(linear.Float("t").Evaluate(AtFace(-1)), 0);
    EXPECT_FALSE(linear.named.readFootprints);
}

TEST_F(PerFace, FloatsOfColorsAreTheirMean) {
    const TextureScene scene =
        Scene(ConstantPtex(4, {0.1f, 0.3f, 0.8f, 100}), "float", R"("string encoding" "linear")");
    EXPECT_NEAR(scene.Float("t").Evaluate(AtFace(0)), 0.4f, 1e-6f);
}

TEST_F(PerFace, ColorsBecomeSpectraByRole) {
    const TextureScene scene = Scene(ConstantPtex(3, {0.1f, 0.3f, 0.8f, 0.5f, -1, 3}), "spectrum",
                                     R"("string encoding" "linear")");
    const RGBColorSpace &space = RGBColorSpace::sRGB();
    const auto got = [&](int face, SpectrumType role) {
        return scene.Spectrum("t", role).Evaluate(AtFace(face), kLambda);
    };
    const RGB c{0.1f, 0.3f, 0.8f};
    for (int i = 0; i < NSpectrumSamples; ++i) {
        EXPECT_EQ(got(0, SpectrumType::Albedo)[i], space.SampleAlbedo(c, kLambda)[i]);
        EXPECT_EQ(got(0, SpectrumType::Unbounded)[i], space.SampleUnbounded(c, kLambda)[i]);
        EXPECT_EQ(got(0, SpectrumType::Illuminant)[i], space.SampleIlluminant(c, kLambda)[i]);
        EXPECT_EQ(got(1, SpectrumType::Albedo)[i], space.SampleAlbedo({0.5f, 0, 1}, kLambda)[i]);
    }
}

TEST_F(PerFace, GreySpectraAreFlat) {
    const TextureScene scene =
        Scene(ConstantPtex(2, {0.25f, 1, 2, 1}), "spectrum", R"("string encoding" "linear")");
    for (int i = 0; i < NSpectrumSamples; ++i) {
        const auto got = [&](int face, SpectrumType role) {
            return scene.Spectrum("t", role).Evaluate(AtFace(face), kLambda)[i];
        };
        EXPECT_EQ(got(0, SpectrumType::Albedo), 0.25f);
        EXPECT_EQ(got(1, SpectrumType::Albedo), 1);
        EXPECT_EQ(got(1, SpectrumType::Unbounded), 2);
    }
}

TEST_F(PerFace, FootprintsWidenTheFilter) {
    PtexContent content;
    content.faces = {{3, 3}};
    for (int i = 0; i < 64; ++i)
        content.texels.push_back(float(i % 2));
    const TextureScene scene = Scene(content, "float", R"("string encoding" "linear")");
    EXPECT_TRUE(scene.named.readFootprints);
    TextureEvalContext ctx = AtFace(0, {3.5f / 8, 0.5f});
    EXPECT_EQ(scene.Float("t").Evaluate(ctx), 1);
    ctx.dudx = 0.125f;
    ctx.dudy = -0.125f;
    EXPECT_NEAR(scene.Float("t").Evaluate(ctx), 0.5f, 1e-6f);
}

TEST_F(PerFace, OneFileIsReadOnce) {
    EXPECT_EQ(WritePtex(Path("a.ptx"), ConstantPtex(1, {1, 2})), std::nullopt);
    const TextureScene scene(R"(Texture "t" "float" "ptex" "string filename" "a.ptx"
                                Texture "u" "spectrum" "ptex" "string filename" "a.ptx")",
                             folder.string());
    EXPECT_EQ(scene.Messages(), "");
    EXPECT_EQ(scene.named.faceFiles.size(), 1u);
}

}  // namespace
}  // namespace pbrt::test
