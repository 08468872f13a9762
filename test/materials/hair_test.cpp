#include "materials/material_text.h"
#include "pbrt/bxdfs/hair_absorption.h"

namespace pbrt::test {
namespace {

constexpr auto kMode = TransportMode::Radiance;
const Vector3f kWo = Normalize(Vector3f{0.2f, 0.5f, 0.8f});
const Vector3f kWi = Normalize(Vector3f{-0.1f, -0.3f, 0.9f});

SampledWavelengths SomeWavelengths() {
    return SampledWavelengths::SampleVisible(0.4f);
}

/// f of the material made from `text` at the surface's (u, v), or of the BxDF that is expected.
SampledSpectrum Value(const std::string &text, Point2f uv) {
    const MaterialText made(text);
    const HairMaterial &hair = made.As<HairMaterial>();
    return hair.GetBxDF(AtUV(uv.x, uv.y), SomeWavelengths()).f(kWo, kWi, kMode);
}
SampledSpectrum Expected(float h, SampledSpectrum sigma_a, float eta = 1.55f, float beta_m = 0.3f,
                         float beta_n = 0.3f, float alpha = 2) {
    return HairBxDF(h, eta, sigma_a, beta_m, beta_n, alpha).f(kWo, kWi, kMode);
}
void ExpectSame(SampledSpectrum a, SampledSpectrum b, float tolerance = 2e-6f) {
    for (int i = 0; i < NSpectrumSamples; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance * b[i]);
}

SampledSpectrum Unbounded(const RGB &rgb) {
    return RGBColorSpace::sRGB().UnboundedSpectrum(rgb).Sample(SomeWavelengths());
}

TEST(HairMaterial, TheOffsetFollowsV) {
    const std::string text = "Material \"hair\" \"spectrum sigma_a\" [ 300 .5 900 .5 ]";
    for (float v : {0.f, 0.3f, 0.5f, 1.f})
        ExpectSame(Value(text, {0.7f, v}), Expected(2 * v - 1, SampledSpectrum(0.5f)));
}

TEST(HairMaterial, DefaultIsBrown) {
    ExpectSame(Value("Material \"hair\"", {0, 0.6f}),
               Expected(0.2f, Unbounded(SigmaAFromConcentration(1.3f, 0))));
}

TEST(HairMaterial, AMelaninThatIsNotGivenCountsNought) {
    ExpectSame(Value("Material \"hair\" \"float pheomelanin\" .7", {0, 0.6f}),
               Expected(0.2f, Unbounded(SigmaAFromConcentration(0, 0.7f))));
    ExpectSame(Value("Material \"hair\" \"float eumelanin\" .7", {0, 0.6f}),
               Expected(0.2f, Unbounded(SigmaAFromConcentration(0.7f, 0))));
}

TEST(HairMaterial, TexturedMelaninIsAsConstant) {
    // The spectra of looked-up colours are interpolated in a table.
    ExpectSame(
        Value("Texture \"e\" \"float\" \"checkerboard\" \"float tex1\" .4 \"float tex2\" 3\n"
              "Material \"hair\" \"texture eumelanin\" \"e\" \"float pheomelanin\" .2",
              {0.2f, 0.6f}),
        Value("Material \"hair\" \"float eumelanin\" .4 \"float pheomelanin\" .2", {0.2f, 0.6f}),
        1e-3f);
}

TEST(HairMaterial, ShapeParameters) {
    ExpectSame(Value("Material \"hair\" \"spectrum sigma_a\" [ 300 .5 900 .5 ] \"float eta\" 1.4 "
                     "\"float beta_m\" .2 \"float beta_n\" .6 \"float alpha\" -3",
                     {0, 0.6f}),
               Expected(0.2f, SampledSpectrum(0.5f), 1.4f, 0.2f, 0.6f, -3));
}

TEST(HairMaterial, ColourIsInvertedWithTheAzimuthalRoughness) {
    const SampledSpectrum colour =
        RGBColorSpace::sRGB().AlbedoSpectrum({0.6f, 0.4f, 0.2f}).Sample(SomeWavelengths());
    for (const char *name : {"reflectance", "color"})
        ExpectSame(Value("Material \"hair\" \"rgb " + std::string(name) +
                             "\" [ .6 .4 .2 ] \"float beta_n\" .6",
                         {0, 0.6f}),
                   Expected(0.2f, SigmaAFromReflectance(colour, 0.6f), 1.55f, 0.3f, 0.6f));
}

TEST(HairMaterial, TheHighestRankCountsAndTheOthersAreWarnedOf) {
    const std::string sigma = "\"rgb sigma_a\" [ 1 2 3 ] ", colour = "\"rgb color\" [ .5 .3 .2 ] ",
                      melanin = "\"float eumelanin\" 1 \"float pheomelanin\" 2 ";
    ExpectSame(Value("Material \"hair\" " + melanin + colour + sigma, {0, 0.6f}),
               Expected(0.2f, Unbounded({1, 2, 3})));
    ExpectSame(Value("Material \"hair\" " + melanin + colour, {0, 0.6f}),
               Value("Material \"hair\" " + colour, {0, 0.6f}));
    EXPECT_EQ(
        MaterialText("Material \"hair\"\n" + colour + "\n" + melanin + "\n" + sigma).Messages(),
        "t.pbrt:3:1: \"color\" has no effect beside \"sigma_a\"\n"
        "t.pbrt:4:1: \"eumelanin\" has no effect beside \"sigma_a\"\n"
        "t.pbrt:4:21: \"pheomelanin\" has no effect beside \"sigma_a\"\n");
    EXPECT_EQ(MaterialText("Material \"hair\"\n" + colour + "\n\"float eumelanin\" 1").Messages(),
              "t.pbrt:4:1: \"eumelanin\" has no effect beside \"color\"\n");
}

TEST(HairMaterial, TexturesOutOfRangeAreClampedAndCounted) {
    const MaterialText made(
        "Texture \"b\" \"float\" \"checkerboard\" \"float tex1\" 3 \"float tex2\" .5\n"
        "Material \"hair\" \"spectrum sigma_a\" [ 300 .5 900 .5 ] \"texture beta_n\" \"b\"");
    EXPECT_EQ(made.Messages(), "");
    ClampCounts counts;
    TextureEvalContext at = AtUV(0.5f, 0.6f);
    at.clamped = &counts;
    EXPECT_EQ(made.As<HairMaterial>().Warnings(counts), "");
    const auto bxdf = made.As<HairMaterial>().GetBxDF(at, SomeWavelengths());
    ExpectSame(bxdf.f(kWo, kWi, kMode), Expected(0.2f, SampledSpectrum(0.5f), 1.55f, 0.3f, 1));
    EXPECT_EQ(made.As<HairMaterial>().Warnings(counts),
              "hair \"beta_n\": 1 texture values outside [0.01, 1] clamped");
}

}  // namespace
}  // namespace pbrt::test
