#include <tuple>

#include "pbrt/lights/light_sampler.h"

#include "lights/light_scene.h"
#include "lights/sampled_lights.h"

namespace pbrt::test {
namespace {

std::string Point(Point3f p, float scale) {
    return "LightSource \"point\" \"point3 from\" [ " + std::to_string(p.x) + " " +
           std::to_string(p.y) + " " + std::to_string(p.z) + " ] \"float scale\" " +
           std::to_string(scale) + "\n";
}
Point3f RandomPoint(std::mt19937 &rng, float size) {
    std::uniform_real_distribution<float> u(-size, size);
    const float x = u(rng), y = u(rng);
    return {x, y, u(rng)};
}
std::string RandomPoints(int n, float loPower, float hiPower) {
    std::mt19937 rng(17);
    std::uniform_real_distribution<float> power(loPower, hiPower);
    std::string world;
    for (int i = 0; i < n; ++i) {
        const Point3f p = RandomPoint(rng, 5);
        world += Point(p, power(rng));
    }
    return world;
}
/// Point, spot and distant lights, a constant sky, and triangles of a ball.
struct Mixed {
    Mixed()
        : scene(RandomPoints(20, 1, 9) +
                "LightSource \"spot\" \"point3 from\" [ 0 3 0 ] "
                "\"point3 to\" [ 1 0 0 ]\n"
                "LightSource \"distant\"\nLightSource \"infinite\"\n"
                "LightSource \"distant\" \"point3 to\" [ 1 1 0 ]\n"),
          area("\"diffuse\"", Rectangle(2, 2, 4)) {
        lights = scene.lights;
        lights.insert(lights.end(), area.lights.begin(), area.lights.end());
    }
    LightScene scene;
    AreaScene area;
    std::vector<Light> lights;
};

LightSampleContext RandomReceiver(std::mt19937 &rng, float size) {
    const Point3f p = RandomPoint(rng, size);
    const Normal3f n = UniformDirection(rng);
    return {p, n};
}

TEST(EveryLightSampler, PMFIsTheProbabilityOfItsSamples) {
    const Mixed mixed;
    std::mt19937 rng(3);
    for (std::string_view name : kLightSamplerNames) {
        const LightSampler sampler = LightSampler::Create(name, mixed.lights);
        for (int k = 0; k < 5; ++k) {
            const LightSampleContext ctx = RandomReceiver(rng, 4);
            // Stratified numbers: each light is drawn pmf n times, but for two per border.
            constexpr int n = 100000;
            std::vector<int> counts(mixed.lights.size());
            for (int i = 0; i < n; ++i) {
                const auto s = sampler.Sample(ctx, (float(i) + 0.5f) / n);
                if (!s) continue;  // a group of which no member reaches the receiver
                EXPECT_EQ(s->pmf, sampler.PMF(ctx, s->light));
                ++counts[size_t(s->light)];
            }
            double sum = 0;
            for (size_t i = 0; i < counts.size(); ++i) {
                const float pmf = sampler.PMF(ctx, int(i));
                EXPECT_NEAR(double(counts[i]) / n, double(pmf), 2e-4) << name << i;
                sum += double(pmf);
            }
            EXPECT_LE(sum, 1 + 1e-5);
        }
    }
}

TEST(EveryLightSampler, ServesSixteenReceiversAsEachAlone) {
    const Mixed mixed;
    std::mt19937 rng(4);
    std::uniform_real_distribution<float> number(0, 1);
    for (std::string_view name : kLightSamplerNames) {
        const LightSampler sampler = LightSampler::Create(name, mixed.lights);
        for (int round = 0; round < 200; ++round) {
            LightSampleContextX16 ctx;
            FloatX16 u;
            for (int i = 0; i < kPacketSize; ++i) {
                const LightSampleContext one = RandomReceiver(rng, 4);
                SetLane(&ctx.p, i, one.p);
                SetLane(&ctx.ns, i, one.ns);
                u.Set(i, std::min(number(rng), OneMinusEpsilon));
            }
            const LaneBits lanes = rng() & kAllLanes;
            ExpectAsEachAlone(sampler, ctx, u, lanes);
        }
    }
}

TEST(EveryLightSampler, NeverDrawsAConstantSky) {
    const Mixed mixed;
    for (std::string_view name : kLightSamplerNames) {
        const LightSampler sampler = LightSampler::Create(name, mixed.lights);
        for (size_t i = 0; i < mixed.lights.size(); ++i)
            if (std::holds_alternative<UniformInfiniteLight>(mixed.lights[i])) {
                EXPECT_EQ(sampler.PMF({}, int(i)), 0);
            }
        const LightScene sky("LightSource \"infinite\"");
        EXPECT_FALSE(LightSampler::Create(name, sky.lights).Sample({}, 0.5f));
        EXPECT_EQ(LightSampler::Create(name, sky.lights).PMF({}, 0), 0);
        EXPECT_FALSE(LightSampler::Create(name, {}).Sample({}, 0.5f));
    }
}

TEST(EveryLightSampler, AloneALightIsCertain) {
    const LightScene s("LightSource \"infinite\"\nLightSource \"point\"");
    for (std::string_view name : kLightSamplerNames) {
        const LightSampler sampler = LightSampler::Create(name, s.lights);
        const auto chosen = sampler.Sample({{1, 2, 3}, {}}, 0.9f);
        ASSERT_TRUE(chosen);
        EXPECT_EQ(chosen->light, 1);
        EXPECT_EQ(chosen->pmf, 1);
        EXPECT_EQ(sampler.PMF({{1, 2, 3}, {}}, 1), 1);
    }
}

TEST(UniformLightSampler, IsUniform) {
    const LightScene s(RandomPoints(8, 1, 100));
    const LightSampler sampler = LightSampler::Create("uniform", s.lights);
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(sampler.PMF({}, i), 0.125f);
}

TEST(PowerLightSampler, IsProportionalToPower) {
    const LightScene s(RandomPoints(8, 1, 100));
    const LightSampler sampler = LightSampler::Create("power", s.lights);
    float total = 0;
    for (const Light &light : s.lights)
        total += Power(light);
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(sampler.PMF({}, i), Power(s.lights[size_t(i)]) / total, 1e-6);
}

TEST(BVHLightSampler, OneSpotIsDrawnWhereverItShines) {
    // With a second light out of reach, so that the tree is asked.
    const LightScene s(
        "LightSource \"spot\" \"point3 to\" [ 0 0 1 ] \"float coneangle\" 45\n"
        "LightSource \"spot\" \"point3 from\" [ 0 0 -1000 ] \"point3 to\" "
        "[ 0 0 -2000 ] \"float coneangle\" 45\n");
    const LightSampler sampler = LightSampler::Create("bvh", s.lights);
    std::mt19937 rng(5);
    for (int i = 0; i < 1000; ++i) {
        const LightSampleContext ctx = RandomReceiver(rng, 5);
        const auto li = SampleLi(s.lights[0], ctx, {}, kLambda);
        const auto chosen = sampler.Sample(ctx, UniformSquare(rng).x);
        if (li && Dot(li->wi, ctx.ns) > 0) {
            ASSERT_TRUE(chosen);
            EXPECT_EQ(chosen->light, 0);
            EXPECT_EQ(chosen->pmf, 1);
        }
    }
}

/// Sum of 1 / (p N) over N lights' draws has mean 1 where each is drawn.
TEST(BVHLightSampler, PointLightsAreDrawnWithoutBias) {
    for (auto [lights, lo, hi] : {std::tuple(33, 1.f, 1.f), std::tuple(82, 1.f, 100.f)}) {
        const LightScene s(RandomPoints(lights, lo, hi));
        const LightSampler sampler = LightSampler::Create("bvh", s.lights);
        std::mt19937 rng(6);
        for (int k = 0; k < 4; ++k) {
            const LightSampleContext ctx{RandomPoint(rng, 5), {}};
            constexpr int n = 200000;
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                const auto chosen = sampler.Sample(ctx, (float(i) + 0.5f) / n);
                ASSERT_TRUE(chosen);
                sum += 1 / double(chosen->pmf);
            }
            // Strata leave at most a draw more or less per light: that of a light of pmf 1e-5
            // makes 1 / (1e-5 n lights), less than 2 %.
            EXPECT_NEAR(sum / n / lights, 1, 0.02);
        }
    }
}

TEST(BVHLightSampler, FromFarAwayGoesByPower) {
    const LightScene s(RandomPoints(82, 1, 100));
    const LightSampler sampler = LightSampler::Create("bvh", s.lights);
    float total = 0;
    for (const Light &light : s.lights)
        total += Power(light);
    std::mt19937 rng(7);
    for (int k = 0; k < 10; ++k) {
        const LightSampleContext ctx{10000.f * UniformDirection(rng), {}};
        for (size_t i = 0; i < s.lights.size(); ++i)
            EXPECT_NEAR(sampler.PMF(ctx, int(i)) * total / Power(s.lights[i]), 1, 0.01);
    }
}

TEST(BVHLightSampler, HasNoFalseNegativesForTriangles) {
    std::mt19937 rng(8);
    std::uniform_real_distribution<float> u(-1, 1);
    for (int k = 0; k < 100; ++k) {
        TriangleMesh mesh;
        for (int i = 0; i < 12; ++i) {
            const Point3f p = RandomPoint(rng, 1);
            mesh.p.push_back(p);
            mesh.indices.push_back(uint32_t(i));
        }
        const AreaScene s("\"diffuse\"", mesh);
        const LightSampler sampler = LightSampler::Create("bvh", s.lights);
        for (int i = 0; i < 100; ++i) {
            const LightSampleContext ctx = RandomReceiver(rng, i % 2 == 0 ? 1.5f : 10);
            for (size_t light = 0; light < s.lights.size(); ++light) {
                const auto li = SampleLi(s.lights[light], ctx, UniformSquare(rng), kLambda);
                if (li && Dot(li->wi, ctx.ns) > 0) {
                    EXPECT_GT(sampler.PMF(ctx, int(light)), 0);
                }
            }
        }
    }
}

TEST(BVHLightSampler, InfiniteLightsShareEvenly) {
    const Mixed mixed;
    const LightSampler sampler = LightSampler::Create("bvh", mixed.lights);
    std::mt19937 rng(9);
    const LightSampleContext ctx = RandomReceiver(rng, 3);
    for (size_t i = 0; i < mixed.lights.size(); ++i)
        if (std::holds_alternative<DistantLight>(mixed.lights[i])) {
            EXPECT_FLOAT_EQ(sampler.PMF(ctx, int(i)), 1 / 3.f);
        }
}

TEST(BVHLightSampler, ManyLightsInOnePlaceStillMakeATree) {
    std::string world;
    for (int i = 0; i < 3000; ++i)
        world += Point({1, 2, 3}, 1);
    const LightScene s(world);
    const LightSampler sampler = LightSampler::Create("bvh", s.lights);
    float sum = 0;
    for (int i = 0; i < 3000; ++i)
        sum += sampler.PMF({{0, 0, 0}, {}}, i);
    EXPECT_NEAR(sum, 1, 1e-4);
}

TEST(BVHLightSampler, GeometricRowsStillMakeATree) {
    // Each plane cuts off a few lights only: the depth limit takes over.
    std::string world;
    for (int i = 0; i < 100; ++i)
        world += Point({std::pow(0.5f, float(i)), 0, 0}, 1);
    const LightScene s(world);
    const LightSampler sampler = LightSampler::Create("bvh", s.lights);
    float sum = 0;
    for (int i = 0; i < 100; ++i) {
        EXPECT_GT(sampler.PMF({{0, 1, 0}, {}}, i), 0);
        sum += sampler.PMF({{0, 1, 0}, {}}, i);
    }
    EXPECT_NEAR(sum, 1, 1e-4);
}

TEST(BVHLightSampler, DarkLightsAreNeverDrawn) {
    const LightScene s(Point({0, 0, 0}, 0) + Point({1, 0, 0}, 1) + Point({2, 0, 0}, 1));
    const LightSampler sampler = LightSampler::Create("bvh", s.lights);
    EXPECT_EQ(sampler.PMF({{0, 1, 0}, {}}, 0), 0);
    for (float u : {0.f, 0.25f, OneMinusEpsilon})
        EXPECT_NE(sampler.Sample({{0, 1, 0}, {}}, u)->light, 0);
}

}  // namespace
}  // namespace pbrt::test
