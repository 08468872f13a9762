#include "lights/light_scene.h"

namespace pbrt::test {
namespace {

const std::string kUnit = "\"diffuse\" \"spectrum L\" " + kFlat;

/// Illuminance at p, normal n, by light sampling; every primitive in turn.
double Illuminance(const std::vector<Light> &lights, Point3f p, Normal3f n, int samples) {
    std::mt19937 rng(7);
    double sum = 0;
    for (const Light &light : lights) {
        for (int i = 0; i < samples; ++i) {
            const auto s = SampleLi(light, {p, n}, UniformSquare(rng), kLambda);
            if (s)
                sum +=
                    double(s->L[0] * kLuminance * std::max(0.f, Dot(n, s->wi)) / s->pdf) / samples;
        }
    }
    return sum;
}

/// Centre of a parallel rectangle of radiance 1 above (Lambert's formula for four corners).
double RectangleIlluminance(double width, double depth, double distance) {
    const double a = width / 2 / distance, b = depth / 2 / distance;
    return 2 * (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
                b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b)));
}

TEST(DiffuseAreaLight, LightsAParallelPatchAsTheClosedFormSays) {
    const AreaScene s(kUnit, Rectangle(2, 1, 0));
    ASSERT_EQ(s.lights.size(), 2u);
    // Both triangles by their solid angle: the cosine alone varies; 20000 samples give 0.1 %.
    EXPECT_NEAR(Illuminance(s.lights, {0, 0, 0.7f}, {0, 0, -1}, 20000),
                RectangleIlluminance(2, 1, 0.7), 4e-3);
}

TEST(DiffuseAreaLight, ShinesFromItsOutsideOnlyUnlessTwoSided) {
    const AreaScene one(kUnit, Rectangle(2, 1, 0));
    const AreaScene two(kUnit + " \"bool twosided\" true", Rectangle(2, 1, 0));
    EXPECT_EQ(Illuminance(one.lights, {0, 0, -0.7f}, {0, 0, 1}, 100), 0);
    EXPECT_NEAR(Illuminance(two.lights, {0, 0, -0.7f}, {0, 0, 1}, 20000),
                RectangleIlluminance(2, 1, 0.7), 4e-3);
    const auto seen = [](const AreaScene &s, Vector3f w) {
        return L(s.lights[0], {}, {0, 0, 1}, {}, w, kLambda)[3] * kLuminance;
    };
    EXPECT_NEAR(seen(one, {0, 0, 1}), 1, 1e-4);
    EXPECT_EQ(seen(one, {0, 0, -1}), 0);
    EXPECT_NEAR(seen(two, {0, 0.6f, -0.8f}), 1, 1e-4);
}

TEST(DiffuseAreaLight, PowerIsWhatEachPrimitiveEmits) {
    for (const char *sides : {"false", "true"}) {
        const std::string params = kUnit + " \"bool twosided\" " + sides;
        const AreaScene s(params + " \"float power\" 9", Rectangle(2, 3, 0));
        const AreaScene unit(params, Rectangle(2, 3, 0));
        EXPECT_NEAR(Power(s.lights[0]), 9, 1e-4);
        EXPECT_NEAR(Power(s.lights[1]), 9, 1e-4);
        EXPECT_NEAR(Power(unit.lights[0]), Pi * 3 * (sides[0] == 't' ? 2 : 1), 1e-3);
    }
}

TEST(DiffuseAreaLight, ShadowRaysEndBeforeItsSurface) {
    const AreaScene s(kUnit, Rectangle(2, 1, 1000));
    std::mt19937 rng(1);
    for (int i = 0; i < 100; ++i) {
        const auto li = SampleLi(s.lights[0], {{0, 0, 1003}, {}}, UniformSquare(rng), kLambda);
        ASSERT_TRUE(li);
        EXPECT_GT(li->pLight.z, 1000);
        EXPECT_LT(li->pLight.z, 1000.1f);
        EXPECT_FALSE(li->delta);
    }
}

TEST(DiffuseAreaLight, FadesWithTheShapesAlpha) {
    struct RightHalf : FloatNode {
        float Evaluate(const TextureEvalContext &ctx) const override { return ctx.p.x > 0; }
    };
    const AreaScene whole(kUnit, Rectangle(2, 1, 0));
    const AreaScene half(kUnit, Rectangle(2, 1, 0), FloatTexture(std::make_shared<RightHalf>()));
    // Half of 20000 samples count: their number varies by 0.7 % (1 sigma) of it.
    const double all = Illuminance(whole.lights, {0, 0, 0.7f}, {0, 0, -1}, 20000);
    EXPECT_NEAR(Illuminance(half.lights, {0, 0, 0.7f}, {0, 0, -1}, 20000), all / 2, 0.015 * all);
}

TEST(DiffuseAreaLight, WithAlphaZeroIsFoundByLightSamplesAlone) {
    const AreaScene whole(kUnit, Rectangle(2, 1, 0));
    const AreaScene hidden(kUnit, Rectangle(2, 1, 0), 0.f);
    EXPECT_EQ(Illuminance(hidden.lights, {0, 0, 0.7f}, {0, 0, -1}, 50),
              Illuminance(whole.lights, {0, 0, 0.7f}, {0, 0, -1}, 50));
    EXPECT_TRUE(SampleLi(hidden.lights[0], {{0, 0, 1}, {}}, {0.3f, 0.3f}, kLambda)->delta);
}

}  // namespace
}  // namespace pbrt::test
