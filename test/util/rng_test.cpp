#include "pbrt/util/rng.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace pbrt {
namespace {

// Statistical checks use fixed seeds and bounds of at least 4.5 standard deviations.

TEST(Hash, OneInputBitFlipsHalfTheOutputBits) {
    Rng rng(5);
    const int trials = 2000;
    for (int in = 0; in < 64; ++in) {
        std::array<int, 64> flips{};
        for (int t = 0; t < trials; ++t) {
            const uint64_t x = rng.Next64();
            const uint64_t d = Mix64(x) ^ Mix64(x ^ (uint64_t(1) << in));
            for (size_t out = 0; out < 64; ++out)
                flips[out] += int(d >> out & 1);
        }
        for (int f : flips)
            EXPECT_NEAR(f, trials / 2, 5.5 * std::sqrt(trials) / 2);
    }
}

TEST(Hash, KnowsOrderTypesAndZeros) {
    EXPECT_NE(Hash(1, 2), Hash(2, 1));
    EXPECT_NE(Hash(0), Hash(0, 0));
    EXPECT_EQ(Hash(0.f), Hash(-0.f));
    EXPECT_NE(Hash(1.f), Hash(1));
    EXPECT_EQ(Hash(Point2i{3, 4}), Hash(3, 4));
    EXPECT_EQ(Hash(Vector3f{1, 2, 3}), Hash(1.f, 2.f, 3.f));
}

TEST(Hash, NoCollisionsOnAGrid) {
    std::set<uint64_t> seen;
    for (int x = -256; x < 256; ++x) {
        for (int y = -256; y < 256; ++y)
            EXPECT_TRUE(seen.insert(Hash(x, y)).second);
    }
}

TEST(Rng, UniformInAllBitsAndStreams) {
    for (uint64_t seed : {0, 1, 2}) {
        Rng rng(seed);
        const int n = 100000;
        std::array<int, 64> ones{};
        double sum = 0, products = 0;
        float last = rng.Uniform();
        for (int i = 0; i < n; ++i) {
            const uint64_t x = rng.Next64();
            for (size_t b = 0; b < 64; ++b)
                ones[b] += int(x >> b & 1);
            const float u = rng.Uniform();
            ASSERT_TRUE(u >= 0 && u < 1);
            sum += u, products += (u - 0.5) * (last - 0.5);
            last = u;
        }
        for (int o : ones)
            EXPECT_NEAR(o, n / 2, 4.5 * std::sqrt(n) / 2);
        EXPECT_NEAR(sum / n, 0.5, 4.5 / std::sqrt(12.0 * n));
        EXPECT_NEAR(products / n, 0, 4.5 / 12 / std::sqrt(n));
    }
}

TEST(Rng, SkipIsAsIfDrawn) {
    Rng a(7), b(7);
    for (int i = 0; i < 1000; ++i)
        a.Next64();
    b.Skip(1000);
    EXPECT_EQ(a.Next64(), b.Next64());
    EXPECT_NE(Rng(0).Next64(), Rng(1).Next64());
}

TEST(Rng, BelowHitsEveryValueAlike) {
    Rng rng(8);
    std::array<int, 7> count{};
    const int n = 70000;
    for (int i = 0; i < n; ++i)
        ++count[rng.Below(7)];
    for (int c : count)
        EXPECT_NEAR(c, n / 7, 4.5 * std::sqrt(n / 7.0));
}

TEST(ToUnitFloat, NeverReachesOne) {
    EXPECT_EQ(ToUnitFloat(0xffffffff), OneMinusEpsilon);
    EXPECT_EQ(ToUnitFloat(0), 0);
}

}  // namespace
}  // namespace pbrt
