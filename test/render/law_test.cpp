// Laws of the whole renderer: repeatability, dispersion, furnace.

#include <fmt/format.h>

#include <cstring>

#include "render/render_text.h"

namespace pbrt::test {
namespace {

constexpr char kHead[] =
    "LookAt 0 1 4  0 0.5 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
    "Film \"rgb\" \"integer xresolution\" 48 \"integer yresolution\" 40\n"
    "Sampler \"zsobol\" \"integer pixelsamples\" 16\n"
    "Integrator \"path\" \"integer maxdepth\" 6\nWorldBegin\n";

std::string Mixed() {
    return std::string(kHead) +
           "LightSource \"infinite\" \"rgb L\" [ .5 .6 .7 ]\n"
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [ 8 7 6 ]\n"
           "Translate 0 3 0 Shape \"sphere\" \"float radius\" .3\nAttributeEnd\n"
           "Material \"diffuse\" \"rgb reflectance\" [ .7 .5 .3 ]\n"
           "Shape \"disk\" \"float radius\" 5 \"float height\" -1\n"
           "AttributeBegin\nMaterial \"dielectric\" \"spectrum eta\" \"glass-BK7\"\n"
           "Translate -.8 .5 0 Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n"
           "AttributeBegin\nMaterial \"featherbarbule\"\nTranslate .6 .5 0\n"
           "Shape \"sphere\" \"float radius\" .6\nAttributeEnd\n"
           "MakeNamedMaterial \"paper\" \"string type\" \"diffusetransmission\"\n"
           "Material \"coateddiffuse\" \"float roughness\" .1\n"
           "Shape \"sphere\" \"float radius\" .2\n"
           "MakeNamedMaterial \"vane\" \"string type\" \"featherbarbule\" \"float spacing\" 3\n"
           "AttributeBegin\nMaterial \"mix\" \"string materials\" [ \"paper\" \"vane\" ]\n"
           "Translate 0 .2 1 Shape \"sphere\" \"float radius\" .2\nAttributeEnd\n"
           "AttributeBegin\nMaterial \"conductor\" \"float roughness\" .1\nTranslate 0 1.4 -.5\n"
           "Shape \"sphere\" \"float radius\" .3 \"float alpha\" .7\nAttributeEnd\n";
}

TEST(Render, SameBitsForAnyNumberOfThreads) {
    const Image one = RenderText(Mixed(), {.nThreads = 1});
    const Image two = RenderText(Mixed(), {.nThreads = 2});
    const Image again = RenderText(Mixed(), {.nThreads = 2});
    ASSERT_EQ(one.Data().size(), two.Data().size());
    EXPECT_EQ(0, std::memcmp(one.Data().data(), two.Data().data(), one.Data().size() * 4));
    EXPECT_EQ(0, std::memcmp(again.Data().data(), two.Data().data(), one.Data().size() * 4));
}

TEST(Render, SeedsDiffer) {
    const Image a = RenderText(Mixed()), b = RenderText(Mixed(), {.seed = 1});
    EXPECT_NE(a.Data(), b.Data());
}

TEST(Render, DispersionKeepsTheMean) {
    // The same index as a number, and as a spectrum that ends the secondary wavelengths.
    const auto glass = [](const char *eta) {
        return std::string(kHead) +
               "LightSource \"infinite\" \"rgb L\" [ .5 .7 .9 ]\nMaterial \"dielectric\" " + eta +
               "\nTranslate 0 .5 0 Shape \"sphere\" \"float radius\" .8\n";
    };
    const auto whole = Mean(RenderText(glass("\"float eta\" 1.5"), {.spp = 64}));
    const auto ended =
        Mean(RenderText(glass("\"spectrum eta\" [ 300 1.5 900 1.5 ]"), {.spp = 256}));
    // One wavelength a path: colour noise of 0.5 M samples, standard error below 0.2 %.
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(ended[c] / whole[c], 1, 0.01) << c;
}

TEST(Sensor, TerminatedWavelengthsDoNotCount) {
    Diagnostics log;
    ParamDict params(ParsedParameters{}, {}, "film", &RGBColorSpace::sRGB(), &log);
    const Sensor sensor = Sensor::Create(params, RGBColorSpace::sRGB());
    SampledWavelengths lambda = SampledWavelengths::SampleVisible(0.3f);
    const SampledSpectrum one(1.f);
    lambda.TerminateSecondary();
    SampledSpectrum garbage = one;
    for (int i = 1; i < NSpectrumSamples; ++i)
        garbage.Set(i, 1e9f * float(i));
    const RGB clean = sensor.Response(one, lambda), dirty = sensor.Response(garbage, lambda);
    EXPECT_EQ(clean, dirty);
    // The one wavelength that is left counts as if it had been drawn alone.
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
        SampledWavelengths l = SampledWavelengths::SampleVisible((i + 0.5f) / kSteps);
        l.TerminateSecondary();
        sum += RGBColorSpace::sRGB().ToXYZ(sensor.Response(garbage, l)).Y / kSteps;
    }
    EXPECT_NEAR(sum, CIE_Y_integral, 0.2);
}

TEST(Furnace, FeatherIsNeverBrighterThanItsSurroundings) {
    // A white environment of 1 and a mirror-like film: what comes back is at most 1.
    const std::string text =
        std::string(kHead) +
        "LightSource \"infinite\" \"spectrum L\" [ 300 1 900 1 ]\n"
        "Material \"featherbarbule\" \"spectrum eta\" [ 300 9 900 9 ] \"float thickness\" 120 "
        "\"spectrum melanin\" [ 300 1 900 1 ]\n"
        "Translate 0 .5 0 Shape \"sphere\" \"float radius\" 1.2\n";
    const Image image = RenderText(text, {.spp = 1024});
    for (int y = 0; y < image.Resolution().y; ++y)
        for (int x = 0; x < image.Resolution().x; ++x) {
            const float *p = image.Pixel({x, y});
            const float Y = RGBColorSpace::sRGB().ToXYZ({p[0], p[1], p[2]}).Y;
            // Noise of 1024 samples with weights below 2.7: 5 sigma.
            EXPECT_LE(Y, 1.1f) << x << ' ' << y;
            EXPECT_GE(Y, 0.f) << x << ' ' << y;
        }
    const auto mean = Mean(image);
    EXPECT_LE(mean[1], 1.005);
}

}  // namespace
}  // namespace pbrt::test
