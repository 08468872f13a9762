// Bodies that absorb nothing, in surroundings of radiance 1, cannot be seen.

#include "render/render_text.h"

namespace pbrt::test {
namespace {

/// A material that absorbs nothing, and how far a pixel's mean may stray: five standard deviations
/// of 1024 samples whose weights differ from 1 where sampling is not exact.
struct Lossless {
    std::string name, material;
    double tolerance = 1e-4;
};

std::ostream &operator<<(std::ostream &out, const Lossless &c) {
    return out << c.name;
}

const std::vector<Lossless> &Cases() {
    static const std::vector<Lossless> cases{
        {"Diffuse", "Material \"diffuse\" \"spectrum reflectance\" [ 300 1 900 1 ]"},
        {"Hair", "Material \"hair\" \"spectrum sigma_a\" [ 300 0 900 0 ]"},
        {"DiffuseTransmission",
         "Material \"diffusetransmission\" \"spectrum reflectance\" [ 300 .3 900 .3 ] \"spectrum "
         "transmittance\" [ 300 .7 900 .7 ]"},
        {"CoatedDiffuse",
         "Material \"coateddiffuse\" \"spectrum reflectance\" [ 300 1 900 1 ] \"float thickness\" "
         "0",
         1.6e-2},
        {"Mix",
         "MakeNamedMaterial \"hair\" \"string type\" \"hair\" \"spectrum sigma_a\" [ 300 0 900 0 "
         "]\n"
         "MakeNamedMaterial \"wall\" \"string type\" \"diffuse\" \"spectrum reflectance\" [ 300 1 "
         "900 "
         "1 ]\nMaterial \"mix\" \"string materials\" [ \"hair\" \"wall\" ] \"float amount\" .4"},
    };
    return cases;
}

class LosslessFurnace : public testing::TestWithParam<Lossless> {};

TEST_P(LosslessFurnace, CannotBeSeen) {
    const std::string text =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
        "Film \"rgb\" \"integer xresolution\" 12 \"integer yresolution\" 12\n"
        "Sampler \"independent\" \"integer pixelsamples\" 1024\n"
        "Integrator \"path\" \"integer maxdepth\" 1000\nWorldBegin\n"
        "LightSource \"infinite\" \"spectrum L\" [ 300 1 900 1 ]\n" +
        GetParam().material + "\nShape \"sphere\" \"float radius\" 1.2\n";
    const Image image = RenderText(text, {.strategy = LightStrategy::BSDFOnly}),
                empty = RenderText(text.substr(0, text.rfind("\nShape")));
    for (int y = 0; y < image.Resolution().y; ++y)
        for (int x = 0; x < image.Resolution().x; ++x)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image.Get({x, y}, c) / empty.Get({x, y}, c), 1, GetParam().tolerance)
                    << x << ' ' << y;
}

INSTANTIATE_TEST_SUITE_P(Materials, LosslessFurnace, testing::ValuesIn(Cases()),
                         [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace pbrt::test
