#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "pbrt/feather/dispersion.h"
#include "pbrt/spectra/spectrum.h"

namespace pbrt {
namespace {

const Spectrum &Get(std::string_view name) {
    const Spectrum *s = GetNamedSpectrum(name);
    if (!s) throw std::runtime_error(std::string(name) + " is missing");
    return *s;
}

/// Power reflected at normal incidence from air.
float Reflectance(const std::string &metal, float lambda) {
    const float n = Get("metal-" + metal + "-eta")(lambda),
                k = Get("metal-" + metal + "-k")(lambda);
    return (Sqr(n - 1) + Sqr(k)) / (Sqr(n + 1) + Sqr(k));
}

TEST(NamedSpectra, IndicesAndReflectancesCoverTheVisibleRange) {
    for (const std::string_view name : NamedSpectrumNames()) {
        const bool isIndex = name.ends_with("-eta") || name.starts_with("glass-");
        if (!isIndex && name != "keratin" && name != "melanin") continue;
        for (float lambda = 360; lambda <= 830; ++lambda)
            EXPECT_GT((*GetNamedSpectrum(name))(lambda), 0) << name << " at " << lambda;
    }
}

TEST(NamedSpectra, HoldThoseOfTheSceneLanguage) {
    for (const std::string metal : {"Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2"}) {
        EXPECT_TRUE(GetNamedSpectrum("metal-" + metal + "-eta")) << metal;
        EXPECT_TRUE(GetNamedSpectrum("metal-" + metal + "-k")) << metal;
    }
    for (const std::string glass : {"BK7", "BAF10", "FK51A", "LASF9", "F5", "F10", "F11"})
        EXPECT_TRUE(GetNamedSpectrum("glass-" + glass)) << glass;
    for (const std::string light : {"A", "D50", "D65", "F1", "F2", "F3", "F4", "F5", "F6", "F7",
                                    "F8", "F9", "F10", "F11", "F12"})
        EXPECT_TRUE(GetNamedSpectrum("stdillum-" + light)) << light;
    for (const std::string other : {"illum-acesD60", "keratin", "melanin"})
        EXPECT_TRUE(GetNamedSpectrum(other)) << other;
    EXPECT_FALSE(GetNamedSpectrum("metal-Ag"));
    EXPECT_FALSE(GetNamedSpectrum(""));
    EXPECT_FALSE(GetNamedSpectrum("zinc"));
}

TEST(NamedSpectra, AreListedUnderTheirNames) {
    const auto names = NamedSpectrumNames();
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const std::string_view name : names) {
        ASSERT_TRUE(GetNamedSpectrum(name)) << name;
        EXPECT_GE(GetNamedSpectrum(name)->MaxValue(), 0) << name;
    }
}

TEST(NamedSpectra, CoverTheVisibleRangeExceptFluorescentLamps) {
    for (const std::string_view name : NamedSpectrumNames()) {
        if (name.ends_with("-k") || name.starts_with("stdillum-F")) continue;
        for (float lambda = 360; lambda <= 830; ++lambda)
            EXPECT_GT((*GetNamedSpectrum(name))(lambda), 0) << name << " at " << lambda;
    }
}

TEST(NamedSpectra, IlluminantsHaveTheirTabulatedChromaticities) {
    struct {
        const char *name;
        float x, y;
    } const expected[] = {
        // CIE 015:2018; ACES: SMPTE ST 2065-1.
        {"stdillum-A", 0.44758f, 0.40745f},   {"stdillum-D50", 0.34567f, 0.35851f},
        {"stdillum-D65", 0.31272f, 0.32903f}, {"stdillum-F2", 0.3721f, 0.3751f},
        {"stdillum-F7", 0.3129f, 0.3292f},    {"stdillum-F11", 0.3805f, 0.3769f},
        {"illum-acesD60", 0.32168f, 0.33767f}};
    for (const auto &e : expected) {
        const Spectrum &s = Get(e.name);
        XYZ c;
        for (float lambda = 380; lambda <= 780; lambda += 5) {  // as the tables are made
            c.X += s(lambda) * spectra::X()(lambda);
            c.Y += s(lambda) * spectra::Y()(lambda);
            c.Z += s(lambda) * spectra::Z()(lambda);
        }
        EXPECT_NEAR(c.X / (c.X + c.Y + c.Z), e.x, 6e-5f) << e.name;
        EXPECT_NEAR(c.Y / (c.X + c.Y + c.Z), e.y, 6e-5f) << e.name;
    }
}

TEST(NamedSpectra, DaylightIsTheTabulatedOne) {
    // CIE 015:2018.
    const Spectrum &d65 = Get("stdillum-D65"), &d50 = Get("stdillum-D50");
    EXPECT_NEAR(d65(400), 82.7549f, 1e-3);
    EXPECT_NEAR(d65(450), 117.008f, 1e-3);
    EXPECT_NEAR(d65(560), 100, 1e-4);
    EXPECT_NEAR(d65(780), 63.3828f, 1e-3);
    EXPECT_NEAR(d50(400), 49.308f, 1e-3);
    EXPECT_NEAR(d50(700), 91.604f, 1e-3);
}

TEST(NamedSpectra, GlassesHaveTheirCatalogueIndexAndAbbeNumber) {
    struct {
        const char *name;
        float nd, abbe;
    } const catalogue[] = {// SCHOTT, optical glass data sheets
                           {"glass-BK7", 1.51680f, 64.17f},   {"glass-BAF10", 1.67003f, 47.11f},
                           {"glass-FK51A", 1.48656f, 84.47f}, {"glass-LASF9", 1.85025f, 32.17f},
                           {"glass-F5", 1.67270f, 32.21f},    {"glass-F10", 1.72825f, 28.41f},
                           {"glass-F11", 1.78472f, 25.76f}};
    for (const auto &g : catalogue) {
        const Spectrum &n = Get(g.name);
        EXPECT_NEAR(n(587.5618f), g.nd, 1e-5f) << g.name;
        const float abbe = (n(587.5618f) - 1) / (n(486.1327f) - n(656.2725f));
        EXPECT_NEAR(abbe, g.abbe, 0.02f) << g.name;
    }
}

TEST(NamedSpectra, MetalsReflectAsMetalsDo) {
    for (const float lambda : {450.f, 550.f, 650.f}) {
        EXPECT_GT(Reflectance("Ag", lambda), 0.9f);
        EXPECT_NEAR(Reflectance("Al", lambda), 0.915f, 0.02f);
    }
    // Gold and copper turn from absorbing to reflecting in the visible.
    EXPECT_LT(Reflectance("Au", 450), 0.45f);
    EXPECT_GT(Reflectance("Au", 650), 0.9f);
    EXPECT_LT(Reflectance("Cu", 500), 0.65f);
    EXPECT_GT(Reflectance("Cu", 650), 0.9f);
    EXPECT_LT(Reflectance("CuZn", 450), 0.6f);
    EXPECT_GT(Reflectance("CuZn", 650), 0.85f);
    EXPECT_NEAR(Get("metal-MgO-eta")(589.3f), 1.7374f, 5e-4f);
    EXPECT_EQ(Get("metal-MgO-k")(589.3f), 0);
    EXPECT_NEAR(Get("metal-TiO2-eta")(589.3f), 2.909f, 5e-3f);  // Devore 1951
}

TEST(NamedSpectra, KeratinAndMelaninHaveTheirPublishedValues) {
    const Spectrum &keratin = Get("keratin"), &melanin = Get("melanin");
    EXPECT_NEAR(keratin(400), 1.569f, 5e-4f);
    EXPECT_NEAR(keratin(500), 1.556f, 5e-4f);
    EXPECT_NEAR(keratin(600), 1.548f, 5e-4f);
    const float reflectance[] = {.0830f, .0779f, .0743f, .0716f, .0697f, .0681f, .0669f};
    for (int i = 0; i < 7; ++i)
        EXPECT_NEAR(melanin(400 + 50.f * i), reflectance[i], 5.1e-5f);
}

TEST(NamedSpectra, KeratinAndMelaninAreThoseOfTheFeatherModel) {
    const Spectrum &keratin = Get("keratin"), &melanin = Get("melanin");
    for (int lambda = int(LambdaMin); lambda <= int(LambdaMax); ++lambda) {
        const feather::Nm<double> nm{double(lambda)};
        EXPECT_EQ(keratin(float(lambda)), float(feather::KeratinIndex(nm))) << lambda;
        EXPECT_EQ(melanin(float(lambda)), float(feather::MelaninReflectance(nm))) << lambda;
    }
}

}  // namespace
}  // namespace pbrt
