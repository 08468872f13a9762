// However lights are chosen, the picture's mean is the same.

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// `n` lamps, patches that face every way, balls, points and spots round a ball that scatters, on a
/// floor that lets light through. `finite`: those alone that a path can meet.
std::string Lamps(int n, const std::string &sampler, bool finite) {
    std::string text =
        "LookAt 0 3 -8  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
        "Sampler \"zsobol\" \"integer pixelsamples\" 64\n"
        "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 24\n"
        "Integrator \"path\" \"integer maxdepth\" 3 \"string lightsampler\" \"" +
        sampler +
        "\"\nWorldBegin\n"
        "Material \"conductor\" \"float roughness\" .6 Shape \"sphere\"\n"
        "Material \"diffusetransmission\" Shape \"bilinearmesh\" \"point3 P\" [ -6 -1.2 -6 "
        "6 -1.2 -6 -6 -1.2 6 6 -1.2 6 ]\nMaterial \"diffuse\"\n";
    for (int k = 0; k < n; ++k) {
        const float angle = 2.4f * float(k), radius = 2 + 0.1f * float(k % 20);
        const std::string place = std::to_string(radius * std::cos(angle)) + " " +
                                  std::to_string(float(k % 7) * 0.6f - 2.2f) + " " +
                                  std::to_string(radius * std::sin(angle));
        const std::string strength = std::to_string((1 + k % 5) * 30.f / float(n));
        if (!finite && k % 4 == 3) {
            text += "LightSource \"point\" \"point3 from\" [ " + place + " ] \"float scale\" " +
                    strength + "\n";
        } else if (!finite && k % 4 == 2) {
            text += "LightSource \"spot\" \"point3 from\" [ " + place +
                    " ] \"float coneangle\" 60 \"float scale\" " + strength + "\n";
        } else {
            text += "AttributeBegin\nTranslate " + place + " Rotate " + std::to_string(77 * k) +
                    " 1 .5 .2\nAreaLightSource \"diffuse\" \"float scale\" " + strength +
                    " \"bool twosided\" " + (k % 3 == 0 ? "true" : "false") + "\n" +
                    (k % 4 == 0
                         ? "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  .5 0 0  0 .5 0  .5 .5 0 ]"
                         : "Shape \"sphere\" \"float radius\" .2") +
                    "\nAttributeEnd\n";
        }
    }
    return text;
}

struct Estimate {
    double mean, sigma;
};
constexpr int kRuns = 8;
Estimate MeanOf(const std::string &text, LightStrategy strategy = LightStrategy::Both) {
    double sum = 0, sumSqr = 0;
    for (int seed = 0; seed < kRuns; ++seed) {
        const double v = Mean(RenderText(text, {.seed = seed, .strategy = strategy}))[1];
        sum += v, sumSqr += v * v;
    }
    const double mean = sum / kRuns;
    return {mean, std::sqrt((sumSqr / kRuns - mean * mean) / (kRuns - 1))};
}
/// Student's t with 14 degrees of freedom at 0.001, two-sided.
void ExpectSame(const Estimate &a, const Estimate &b) {
    EXPECT_NEAR(a.mean, b.mean, 4.14 * std::hypot(a.sigma, b.sigma));
    EXPECT_LT(a.sigma / a.mean, 0.01);
    EXPECT_LT(b.sigma / b.mean, 0.04);
}

class ManyLights : public testing::TestWithParam<int> {};

TEST_P(ManyLights, ChosenByTheTreeOrByPower) {
    ExpectSame(MeanOf(Lamps(GetParam(), "bvh", false)), MeanOf(Lamps(GetParam(), "power", false)));
}

TEST_P(ManyLights, FoundBySamplingOrByChance) {
    const std::string text = Lamps(GetParam(), "bvh", true);
    const Estimate both = MeanOf(text);
    ExpectSame(both, MeanOf(text, LightStrategy::LightsOnly));
    ExpectSame(both, MeanOf(text, LightStrategy::BSDFOnly));
}

INSTANTIATE_TEST_SUITE_P(All, ManyLights, testing::Values(3, 12, 150));

}  // namespace
}  // namespace pbrt::test
