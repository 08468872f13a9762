// Mixes show their materials in the share of `amount`.

#include <fmt/format.h>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// A disk in front of the camera, with `world` before it.
std::string Disk(const std::string &material) {
    return "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
           "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 32\n"
           "Sampler \"zsobol\" \"integer pixelsamples\" 16\n"
           "Integrator \"path\" \"integer maxdepth\" 1\nWorldBegin\n"
           "LightSource \"distant\" \"point3 from\" [ 0 0 1 ] \"point3 to\" [ 0 0 0 ]\n"
           "MakeNamedMaterial \"red\" \"string type\" \"diffuse\" \"rgb reflectance\" [ .8 .1 .1 "
           "]\n"
           "MakeNamedMaterial \"metal\" \"string type\" \"conductor\" \"float roughness\" .5\n" +
           material + "\nShape \"disk\" \"float radius\" 5\n";
}

std::string Mix(float amount) {
    return Disk(fmt::format(
        "Material \"mix\" \"string materials\" [ \"red\" \"metal\" ] \"float amount\" {}", amount));
}

TEST(Mix, TheEndsAreTheMaterialsThemselves) {
    EXPECT_EQ(RenderText(Mix(0)).Data(), RenderText(Disk("NamedMaterial \"red\"")).Data());
    EXPECT_EQ(RenderText(Mix(1)).Data(), RenderText(Disk("NamedMaterial \"metal\"")).Data());
}

TEST(Mix, MeansAreLinearInAmount) {
    const auto red = Mean(RenderText(Mix(0))), metal = Mean(RenderText(Mix(1))),
               mixed = Mean(RenderText(Mix(0.3f)));
    for (int c = 0; c < 3; ++c) {
        // 16384 choices: standard deviation of the share 0.0036; 4 sigma.
        const double share = (mixed[c] - red[c]) / (metal[c] - red[c]);
        EXPECT_NEAR(share, 0.3, 0.0143) << c;
    }
}

TEST(Mix, AmountCanBeATexture) {
    // One sample a pixel, so that each is one of the two; the texture says which.
    const std::string text = Disk(
        "Texture \"a\" \"float\" \"checkerboard\" \"float tex1\" 0 \"float tex2\" 1 \"float "
        "uscale\" "
        "2 \"float vscale\" 2\n"
        "Material \"mix\" \"string materials\" [ \"red\" \"metal\" ] \"texture amount\" \"a\"");
    const Image mixed = RenderText(text, {.spp = 1}), red = RenderText(Mix(0), {.spp = 1}),
                metal = RenderText(Mix(1), {.spp = 1});
    int nRed = 0, nMetal = 0;
    for (size_t i = 0; i < mixed.Data().size(); i += 3) {
        const bool isRed = mixed.Data()[i] == red.Data()[i];
        nRed += isRed, nMetal += !isRed;
        EXPECT_TRUE(isRed || mixed.Data()[i] == metal.Data()[i]);
    }
    EXPECT_GT(nRed, 100);
    EXPECT_GT(nMetal, 100);
}

}  // namespace
}  // namespace pbrt::test
