// diffusetransmission and coateddiffuse: parameters and defaults.

#include "materials/material_text.h"

namespace pbrt::test {
namespace {

constexpr auto kMode = TransportMode::Radiance;
const Vector3f kWo = Normalize(Vector3f{0.2f, 0.5f, 0.8f});
const Vector3f kWi = Normalize(Vector3f{-0.1f, -0.3f, 0.9f});

template <typename M>
auto BxDFOf(const std::string &text) {
    const MaterialText made(text);
    return std::pair(made.As<M>(), SampledWavelengths::SampleVisible(0.4f));
}

/// Reflected and transmitted f of a diffusetransmission, times pi.
std::array<float, 2> BothSides(const std::string &parameters) {
    const auto [material, lambda] =
        BxDFOf<DiffuseTransmissionMaterial>("Material \"diffusetransmission\" " + parameters);
    const auto bxdf = material.GetBxDF(AtUV(0.2f, 0.3f), lambda);
    return {Pi * bxdf.f(kWo, kWi, kMode)[0], Pi * bxdf.f(kWo, -kWi, kMode)[0]};
}

TEST(DiffuseTransmissionMaterial, DefaultsAndScale) {
    const auto [r, t] = BothSides("");
    EXPECT_FLOAT_EQ(r, 0.25f);
    EXPECT_FLOAT_EQ(t, 0.25f);
    const auto [r2, t2] = BothSides(
        "\"rgb reflectance\" [ .4 .4 .4 ] \"rgb transmittance\" "
        "[ .1 .1 .1 ] \"float scale\" 2");
    EXPECT_FLOAT_EQ(r2, 0.8f);
    EXPECT_FLOAT_EQ(t2, 0.2f);
    // Each side reflects and transmits all it gets at most.
    const auto [r3, t3] = BothSides("\"rgb reflectance\" [ .4 .4 .4 ] \"float scale\" 3");
    EXPECT_FLOAT_EQ(r3, 1);
    EXPECT_FLOAT_EQ(t3, 0.75f);
}

float Coated(const std::string &parameters) {
    const auto [material, lambda] =
        BxDFOf<CoatedDiffuseMaterial>("Material \"coateddiffuse\" " + parameters);
    return material.GetBxDF(AtUV(0.2f, 0.3f), lambda).f(kWo, kWi, kMode)[0];
}

TEST(CoatedDiffuseMaterial, Defaults) {
    const std::string all =
        "\"float roughness\" 0 \"float thickness\" .01 \"float eta\" 1.5 \"float g\" 0 "
        "\"spectrum albedo\" [ 300 0 900 0 ] \"integer maxdepth\" 10 \"integer nsamples\" 1 "
        "\"bool remaproughness\" true \"rgb reflectance\" [ .5 .5 .5 ]";
    EXPECT_FLOAT_EQ(Coated(""), Coated(all));
}

TEST(CoatedDiffuseMaterial, ParametersMatter) {
    const float plain = Coated("");
    EXPECT_LT(Coated("\"rgb reflectance\" [ .2 .2 .2 ]"), plain);
    EXPECT_LT(Coated("\"float thickness\" 1"), plain);
    EXPECT_NE(Coated("\"spectrum eta\" [ 300 1.4 900 1.4 ]"), plain);
    EXPECT_GT(Coated("\"float roughness\" .05"), plain);
    // An alpha of 0.3 is a roughness of 0.09.
    EXPECT_NEAR(Coated("\"float roughness\" .09"),
                Coated("\"float roughness\" .3 \"bool remaproughness\" false"), 1e-5f);
}

TEST(CoatedDiffuseMaterial, TexturedRoughnessIsAsConstant) {
    const std::string texture =
        "Texture \"r\" \"float\" \"checkerboard\" \"float tex1\" .09 \"float tex2\" .5\n";
    const MaterialText made(texture + "Material \"coateddiffuse\" \"texture roughness\" \"r\"");
    const float textured = made.As<CoatedDiffuseMaterial>()
                               .GetBxDF(AtUV(0.2f, 0.3f), SampledWavelengths::SampleVisible(0.4f))
                               .f(kWo, kWi, kMode)[0];
    // Interpolated between the columns of a table.
    EXPECT_NEAR(textured / Coated("\"float roughness\" .09"), 1, 3e-3);
}

}  // namespace
}  // namespace pbrt::test
