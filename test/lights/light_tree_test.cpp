#include "pbrt/lights/light_tree.h"

#include "lights/light_scene.h"
#include "lights/sampled_lights.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"
#include "support/chi_square.h"

namespace pbrt::test {
namespace {

Point3f RandomPoint(Rng &rng, float size) {
    const Point2f a = rng.Uniform2D();
    return size * Vector3f{2 * a.x - 1, 2 * a.y - 1, 2 * rng.Uniform() - 1};
}
Vector3f RandomDirection(Rng &rng) {
    return SampleUniformSphere(rng.Uniform2D());
}

/// Points, patches and spots; powers over `decades`, some 0.
std::vector<LightBounds> RandomLights(int n, float decades, uint64_t seed) {
    Rng rng(seed);
    std::vector<LightBounds> lights;
    for (int i = 0; i < n; ++i) {
        const Point3f p = RandomPoint(rng, 3);
        const Vector3f half = 0.1f * rng.Uniform() * Abs(RandomDirection(rng));
        const DirectionCone cone{RandomDirection(rng), i % 3 == 0 ? -1 : 1 - 0.2f * rng.Uniform()};
        const float power = rng.Below(20) == 0 ? 0 : std::pow(10.f, decades * rng.Uniform());
        lights.push_back(
            {{p - half, p + half}, cone, i % 3 == 1 ? 0.7f : 0, power, rng.Below(8) == 0});
    }
    return lights;
}

/// A fourth of them take light from all sides.
LightSampleContextX16 RandomReceivers(Rng &rng, float size) {
    LightSampleContextX16 ctx{};
    for (int i = 0; i < kPacketSize; ++i) {
        SetLane(&ctx.p, i, RandomPoint(rng, size));
        if (rng.Below(4) != 0) SetLane(&ctx.ns, i, RandomDirection(rng));
    }
    return ctx;
}

TEST(LightTree, SixteenReceiversAreServedAsEachAlone) {
    Rng rng(1);
    for (int n : {1, 2, 15, 16, 17, 40, 300, 5000}) {
        const LightTree tree(RandomLights(n, 2, uint64_t(n)));
        for (int round = 0; round < 300; ++round) {
            const LightSampleContextX16 ctx = RandomReceivers(rng, round % 2 ? 3 : 10);
            FloatX16 u;
            for (int i = 0; i < kPacketSize; ++i)
                u.Set(i, rng.Below(8) == 0 ? OneMinusEpsilon : rng.Uniform());
            const LaneBits lanes = round % 3 == 0 ? kAllLanes : rng.Next32() & kAllLanes;
            ExpectAsEachAlone(tree, ctx, u, lanes);
        }
    }
}

TEST(LightTree, TakesLightsAtTheEndOfTheFloats) {
    std::vector<LightBounds> lights = RandomLights(40, 2, 11);
    for (size_t i = 0; i < lights.size(); i += 2) {
        const float far = i % 4 == 0 ? 3e38f : -3e38f;  // apart by more than a float
        lights[i].bounds = {{far, far, far}, {far, far, far}};
    }
    const LightTree tree(lights);
    Rng rng(12);
    for (int round = 0; round < 300; ++round) {
        const LightSampleContextX16 ctx = RandomReceivers(rng, 3);
        FloatX16 u;
        for (int i = 0; i < kPacketSize; ++i)
            u.Set(i, rng.Uniform());
        ExpectAsEachAlone(tree, ctx, u, kAllLanes);
    }
}

TEST(LightTree, ProbabilitiesAreThoseOfTheDraws) {
    Rng rng(2);
    for (auto [n, decades] : {std::pair(7, 0.f), std::pair(100, 3.f), std::pair(1500, 14.f)}) {
        const auto lights = RandomLights(n, decades, 7);
        const LightTree tree(lights);
        int drawn = 0;
        for (int round = 0; round < 40; ++round) {
            const LightSampleContext ctx = RandomReceivers(rng, 5).At(0);
            for (int k = 0; k < 200; ++k) {
                const auto one = tree.Sample(ctx, k == 0 ? 0 : rng.Uniform());
                if (!one) continue;
                ++drawn;
                EXPECT_GT(one->pmf, 0);
                EXPECT_EQ(one->pmf, tree.PMF(ctx, one->light));
                EXPECT_GT(lights[size_t(one->light)].power, 0);
            }
        }
        EXPECT_GT(drawn, 4000);
    }
}

TEST(LightTree, ProbabilitiesSumToOne) {
    Rng rng(6);
    for (int n : {5, 16, 100, 1500}) {
        auto lights = RandomLights(n, 5, 7);
        lights[0].power = 1;
        const LightTree someWays(lights);
        for (LightBounds &light : lights)
            light.normals.cosTheta = -1;
        const LightTree everyWay(lights);
        for (int round = 0; round < 20; ++round) {
            const LightSampleContext ctx = RandomReceivers(rng, 5).At(0);
            const LightSampleContext allSides{ctx.p, {}};
            double some = 0, every = 0;
            for (int i = 0; i < n; ++i) {
                some += double(someWays.PMF(ctx, i));
                every += double(everyWay.PMF(allSides, i));
            }
            // Eight roundings a level; four levels at most.
            constexpr double kRoundings = 32 * 0x1p-24;
            EXPECT_NEAR(every, 1, kRoundings);
            // A group may look as if one of it could reach the receiver, and none does.
            EXPECT_LE(some, 1 + kRoundings);
        }
    }
}

TEST(LightTree, DrawsByItsProbabilities) {
    constexpr int kTests = 24, kDraws = 200000;
    Rng rng(3);
    const LightTree tree(RandomLights(200, 1, 5));
    for (int test = 0; test < kTests; ++test) {
        LightSampleContextX16 ctx = RandomReceivers(rng, 4);
        for (int i = 1; i < kPacketSize; ++i) {
            SetLane(&ctx.p, i, Lane(ctx.p, 0));
            SetLane(&ctx.ns, i, Lane(ctx.ns, 0));
        }
        // The last bin counts draws of nothing.
        std::vector<double> counts(201), expected(201);
        expected[200] = kDraws;
        for (int i = 0; i < 200; ++i) {
            expected[size_t(i)] = double(tree.PMF(ctx.At(0), i)) * kDraws;
            expected[200] -= expected[size_t(i)];
        }
        for (int k = 0; k < kDraws; k += kPacketSize) {
            FloatX16 u;
            for (int i = 0; i < kPacketSize; ++i)
                u.Set(i, rng.Uniform());
            const SampledLights drawn = tree.Sample(ctx, u, kAllLanes);
            ForEachLane(drawn.valid, [&](int i) { ++counts[size_t(drawn.light[size_t(i)])]; });
            counts[200] += kPacketSize - std::popcount(drawn.valid);
        }
        // All tests together fail by chance with probability 0.001.
        EXPECT_GT(TestCounts(counts, expected).pValue, Sidak(0.001, kTests));
    }
}

TEST(LightTree, NeighboursInSpaceAreNeighboursInTheRandomNumber) {
    // A row of equal lights from afar: light k of n is drawn by numbers about k / n.
    std::vector<LightBounds> lights;
    for (int i = 0; i < 500; ++i) {
        const Point3f p{float(i), 0, 0};
        lights.push_back({{p, p}, {{0, 0, 1}, -1}, 0, 1, false});
    }
    const LightTree tree(lights);
    for (int k = 0; k < 1000; ++k) {
        const float u = (float(k) + 0.5f) / 1000;
        const auto drawn = tree.Sample({{250, 0, 1e6f}, {}}, u);
        ASSERT_TRUE(drawn);
        EXPECT_NEAR(drawn->light, u * 500, 1);
    }
}

TEST(LightTree, NodesAreWellFilled) {
    // At most twice what full nodes take, 704 bytes each.
    const LightTree tree(RandomLights(10000, 1, 9));
    EXPECT_LT(tree.MemoryBytes(), 10000 * (8 + 2. * 704 / 15));
}

TEST(LightTree, SixteenClustersAreWhatEachIsAlone) {
    Rng rng(4);
    const auto lights = RandomLights(1600, 2, 8);
    for (size_t first = 0; first < lights.size(); first += kPacketSize) {
        ClusterOf<FloatX16> all;
        for (int i = 0; i < kPacketSize; ++i) {
            const ClusterOf<float> c = Cluster(lights[first + size_t(i)]);
            SetLane(&all.center, i, c.center);
            SetLane(&all.axis, i, c.axis);
            all.radius.Set(i, c.radius), all.spread.Set(i, c.spread);
            all.cosTheta_e.Set(i, c.cosTheta_e), all.signedPower.Set(i, c.signedPower);
        }
        const LightSampleContext ctx = RandomReceivers(rng, 5).At(0);
        const FloatX16 importance = Importance(all, Receiver(ctx.p, ctx.ns));
        for (int i = 0; i < kPacketSize; ++i) {
            const float one = lights[first + size_t(i)].Importance(ctx.p, ctx.ns);
            // The fast root's error of 2^-14 counts four times, next to the margins of 1e-4 in the
            // cosines more.
            EXPECT_NEAR(importance[i], one, 0.01f * one + 1e-6f * lights[first + size_t(i)].power);
        }
    }
}

}  // namespace
}  // namespace pbrt::test
