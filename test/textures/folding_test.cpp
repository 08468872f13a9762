#include "textures/texture_scene.h"

namespace pbrt::test {
namespace {

const SampledWavelengths kLambda = SampledWavelengths::SampleVisible(0.3f);

TEST(ConstantTextures, FoldThroughScaleAndMix) {
    const TextureScene s(R"(
        Texture "c" "float" "constant" "float value" 3
        Texture "s" "float" "scale" "texture tex" "c" "float scale" 2
        Texture "m" "float" "mix" "texture tex1" "s" "float tex2" 2 "float amount" 0.25
    )");
    ASSERT_TRUE(s.Float("m").IsConstant());
    EXPECT_FLOAT_EQ(s.Float("s").Constant(), 6);
    EXPECT_FLOAT_EQ(s.Float("m").Constant(), 0.75f * 6 + 0.25f * 2);
}

TEST(ConstantTextures, FoldForEverySpectrumRole) {
    const TextureScene s(R"(
        Texture "a" "spectrum" "constant" "rgb value" [ .2 .5 .8 ]
        Texture "b" "spectrum" "scale" "texture tex" "a" "float scale" 0.5
        Texture "m" "spectrum" "mix" "texture tex1" "a" "texture tex2" "b" "float amount" 0.3
    )");
    for (SpectrumType role :
         {SpectrumType::Albedo, SpectrumType::Unbounded, SpectrumType::Illuminant}) {
        const SpectrumTexture &a = s.Spectrum("a", role), &m = s.Spectrum("m", role);
        ASSERT_TRUE(m.IsConstant());
        const SampledSpectrum want = a.Evaluate({}, kLambda) * (0.7f + 0.3f * 0.5f);
        const SampledSpectrum got = m.Evaluate({}, kLambda);
        // Mixtures are tabulated at whole nm; linear interpolation of a smooth curve between.
        for (int i = 0; i < NSpectrumSamples; ++i)
            EXPECT_NEAR(got[i], want[i], 2e-3f * want[i]);
    }
}

TEST(ConstantTextures, PlainConstantsStayPlain) {
    const TextureScene s(R"(
        Texture "m" "spectrum" "mix"
    )");
    ASSERT_TRUE(s.Spectrum("m", SpectrumType::Albedo).IsConstant());
    EXPECT_TRUE(s.Spectrum("m", SpectrumType::Albedo).Constant().IsConstant());
    EXPECT_FLOAT_EQ(s.Spectrum("m", SpectrumType::Albedo).Constant()(500), 0.5f);
}

TEST(ConstantTextures, NeutralOperandsVanish) {
    const TextureScene s(R"(
        Texture "c" "float" "checkerboard"
        Texture "s" "float" "scale" "texture tex" "c" "float scale" 1
        Texture "m" "float" "mix" "texture tex1" "c" "float tex2" 7 "float amount" 1
    )");
    EXPECT_FALSE(s.Float("s").IsConstant());
    ASSERT_TRUE(s.Float("m").IsConstant());
    EXPECT_EQ(s.Float("m").Constant(), 7);
}

TEST(ScaleAndMix, CombineTexturesPointByPoint) {
    const TextureScene s(R"(
        Texture "c" "float" "checkerboard" "float tex1" 1 "float tex2" 5
        Texture "d" "float" "checkerboard" "float tex1" 0.25 "float tex2" 0.5 "float udelta" 1
        Texture "s" "float" "scale" "texture tex" "c" "texture scale" "d"
        Texture "m" "float" "mix" "float tex1" 10 "texture tex2" "c" "texture amount" "d"
    )");
    // Even cell: c = 1, d = 0.5; odd cell: c = 5, d = 0.25.
    EXPECT_FLOAT_EQ(s.Float("s").Evaluate(AtUV(0.5f, 0.5f)), 0.5f);
    EXPECT_FLOAT_EQ(s.Float("s").Evaluate(AtUV(1.5f, 0.5f)), 1.25f);
    EXPECT_FLOAT_EQ(s.Float("m").Evaluate(AtUV(0.5f, 0.5f)), 5.5f);
    EXPECT_FLOAT_EQ(s.Float("m").Evaluate(AtUV(1.5f, 0.5f)), 8.75f);
}

}  // namespace
}  // namespace pbrt::test
