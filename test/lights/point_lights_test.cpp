#include <functional>

#include "lights/light_scene.h"

namespace pbrt::test {
namespace {

/// Luminous flux through the unit sphere about `center`: the integral of what arrives head-on over
/// rings and sectors.
double FluxAround(const Light &light, Point3f center, int rings) {
    double sum = 0;
    const int sectors = 16;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < sectors; ++j) {
            const float z = 1 - 2 * (float(i) + 0.5f) / float(rings);
            const float phi = 2 * Pi * (float(j) + 0.5f) / float(sectors), r = SafeSqrt(1 - z * z);
            const Vector3f w{r * std::cos(phi), r * std::sin(phi), z};
            const auto s = SampleLi(light, {center + w, {}}, {0.5f, 0.5f}, kLambda);
            if (s) sum += double(s->L[0] * kLuminance / s->pdf);
        }
    }
    return sum * 4 * double(Pi) / (rings * sectors);
}

TEST(PointLight, ShinesByInverseSquareFromItsPlace) {
    const LightScene s(
        "Translate 1 0 0\nLightSource \"point\" \"point3 from\" [ 0 2 0 ] "
        "\"float scale\" 6 \"spectrum I\" " +
        kFlat);
    const auto li = SampleLi(s.Only(), {{1, 0, 0}, {}}, {}, kLambda);
    ASSERT_TRUE(li);
    EXPECT_EQ(li->pLight, (Point3f{1, 2, 0}));
    EXPECT_EQ(li->wi, (Vector3f{0, 1, 0}));
    EXPECT_EQ(li->pdf, 1);
    EXPECT_TRUE(li->delta);
    EXPECT_NEAR(li->L[2] * kLuminance, 6.f / 4, 1e-4);
    EXPECT_FALSE(SampleLi(s.Only(), {{1, 2, 0}, {}}, {}, kLambda));
}

TEST(PointLight, PowerIsItsFlux) {
    const LightScene s("LightSource \"point\" \"float power\" 50 \"spectrum I\" " + kFlat);
    EXPECT_NEAR(Power(s.Only()), 50, 1e-3);
    EXPECT_NEAR(FluxAround(s.Only(), {}, 100), 50, 1e-2);
}

struct Cone {
    float angle, delta;
};
const std::vector<Cone> kCones{{30, 5}, {60, 60}, {10, 0}, {120, 30}};

std::string Spot(Cone c) {
    return "LightSource \"spot\" \"spectrum I\" " + kFlat + " \"float coneangle\" " +
           std::to_string(c.angle) + " \"float conedeltaangle\" " + std::to_string(c.delta);
}

TEST(SpotLight, PowerIsItsFlux) {
    for (Cone c : kCones) {
        const LightScene s(Spot(c));
        // The ring at the edge of a hard cone is half in: 1 / 20000 of 2 pi.
        EXPECT_NEAR(FluxAround(s.Only(), {}, 20000), Power(s.Only()), 1e-3) << c.angle;
    }
}

TEST(SpotLight, MeetsTheTargetPower) {
    for (Cone c : kCones) {
        const LightScene s(Spot(c) + " \"float power\" 3");
        EXPECT_NEAR(Power(s.Only()), 3, 1e-4);
    }
}

TEST(SpotLight, HasNoVariance) {
    std::mt19937 rng(1);
    for (Cone c : kCones) {
        const LightScene s(Spot(c));
        for (int i = 0; i < 100; ++i) {
            const LightSampleContext ctx{3.f * UniformDirection(rng), {}};
            const auto a = SampleLi(s.Only(), ctx, UniformSquare(rng), kLambda);
            const auto b = SampleLi(s.Only(), ctx, UniformSquare(rng), kLambda);
            ASSERT_EQ(a.has_value(), b.has_value());
            if (!a) continue;
            EXPECT_EQ(a->L[0] / a->pdf, b->L[0] / b->pdf);
        }
    }
}

TEST(SpotLight, FallsOffByASmoothStepOfTheCosine) {
    const LightScene s(Spot({40, 20}));
    const auto &spot = std::get<SpotLight>(s.Only());
    const float start = std::cos(Radians(20)), end = std::cos(Radians(40));
    EXPECT_EQ(spot.Falloff(std::cos(Radians(19.9f))), 1);
    EXPECT_EQ(spot.Falloff(std::cos(Radians(40.1f))), 0);
    EXPECT_NEAR(spot.Falloff((start + end) / 2), 0.5f, 1e-5);
    EXPECT_NEAR(spot.Falloff(0.75f * end + 0.25f * start), 0.15625f, 1e-5);
}

TEST(SpotLight, AimsAsTransformed) {
    const LightScene s(
        "Translate 0 0 5\nRotate 90 0 1 0\nLightSource \"spot\" "
        "\"point3 to\" [ 0 0 3 ]");
    // z turns into x.
    EXPECT_TRUE(SampleLi(s.Only(), {{4, 0, 5}, {}}, {}, kLambda));
    EXPECT_FALSE(SampleLi(s.Only(), {{0, 0, 9}, {}}, {}, kLambda));
}

TEST(DistantLight, ArrivesParallelWithItsIlluminance) {
    const LightScene s(
        "LightSource \"distant\" \"point3 from\" [ 0 0 8 ] \"point3 to\" [ 0 0 0 ] "
        "\"float illuminance\" 12 \"float scale\" 2 \"blackbody L\" 5000");
    double luminance = 0;
    // The mean of L / pdf over wavelengths times y is the luminance.
    for (int i = 0; i < 1000; ++i) {
        const auto lambda = SampledWavelengths::SampleVisible((float(i) + 0.5f) / 1000);
        const auto li = SampleLi(s.Only(), {{1, 2, 3}, {}}, {}, lambda);
        ASSERT_TRUE(li && li->delta);
        EXPECT_EQ(li->wi, (Vector3f{0, 0, 1}));
        // Beyond everything in a scene of radius 10.
        EXPECT_GT(li->pLight.z, 13);
        luminance += double((li->L / lambda.PDF() * spectra::Y().Sample(lambda)).Average());
    }
    EXPECT_NEAR(luminance / 1000, 24, 0.02);
    EXPECT_NEAR(Power(s.Only()), Pi * 100 * 24, 1);
}

TEST(UniformInfiniteLight, GivesItsIlluminance) {
    const LightScene s("LightSource \"infinite\" \"float illuminance\" 5 \"spectrum L\" " + kFlat);
    const SampledSpectrum L = Le(s.Only(), {{0, 0, 0}, {0, 0, 1}}, kLambda);
    EXPECT_NEAR(Pi * L[1] * kLuminance, 5, 1e-3);
    EXPECT_TRUE(Traits(s.Only()).isInfinite);
    EXPECT_FALSE(SampleLi(s.Only(), {}, {0.5f, 0.5f}, kLambda));
    EXPECT_EQ(PDF_Li(s.Only(), {0, 0, 0}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace pbrt::test
