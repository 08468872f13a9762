#include "materials/material_text.h"

namespace pbrt::test {
namespace {

template <typename M>
void ExpectClampedToSmooth(const std::string &type) {
    const MaterialText made(
        "Texture \"r\" \"float\" \"scale\" \"float tex\" -1 \"float scale\" 0.5\n"
        "Texture \"rough\" \"float\" \"checkerboard\" \"texture tex1\" \"r\" \"float tex2\" 1\n"
        "Material \"" +
        type + "\" \"texture roughness\" \"rough\"");
    const M &material = made.As<M>();
    ClampCounts counts;
    TextureEvalContext at = AtUV(0.2f, 0.6f);
    at.clamped = &counts;
    const Vector2f alpha = material.roughness.Alpha(at);
    EXPECT_EQ(alpha.x, 0);
    EXPECT_EQ(alpha.y, 0);
    EXPECT_EQ(material.Warnings(counts),
              type + " \"roughness\": 2 texture values outside [0, 1000000] clamped");
}

// A negative roughness has no square root.
TEST(Roughness, TexturesOutOfRangeAreClampedAndCounted) {
    ExpectClampedToSmooth<ConductorMaterial>("conductor");
    ExpectClampedToSmooth<DielectricMaterial>("dielectric");
    ExpectClampedToSmooth<CoatedDiffuseMaterial>("coateddiffuse");
}

TEST(Roughness, EachDirectionHasItsOwn) {
    const MaterialText made(
        "Material \"conductor\" \"float roughness\" .25 \"float vroughness\" .36");
    const Vector2f alpha = made.As<ConductorMaterial>().roughness.Alpha(AtUV(0, 0));
    EXPECT_FLOAT_EQ(alpha.x, 0.5f);
    EXPECT_FLOAT_EQ(alpha.y, 0.6f);
    EXPECT_EQ(made.As<ConductorMaterial>().Warnings({}), "");
}

}  // namespace
}  // namespace pbrt::test
