#include "pbrt/util/lanes.h"

#include <gtest/gtest.h>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

TEST(Lanes, ExpWithinStatedError) {
    Rng rng(1);
    for (int i = 0; i < 100000; ++i) {
        const float scale = i % 2 ? 87 : 1;
        Lanes x;
        for (int l = 0; l < 4; ++l)
            x[l] = scale * (2 * rng.Uniform() - 1);
        const Lanes y = Exp(x);
        for (int l = 0; l < 4; ++l)
            ASSERT_NEAR(y[l] / std::exp(double(x[l])), 1, 2e-7) << x[l];
    }
}

TEST(Lanes, LogWithinStatedError) {
    for (double x = 1e-30; x < 1e30; x *= 1.001) {
        const float at = float(x);
        const double exact = std::log(double(at));
        EXPECT_NEAR(Log(Broadcast(at))[0], exact, 1.5e-7 + 1.2e-7 * std::abs(exact)) << at;
    }
}

TEST(Lanes, ExpAtTheEnds) {
    const Lanes y = Exp(Lanes{0, -1e30f, 1e30f, -Infinity});
    EXPECT_EQ(y[0], 1);
    EXPECT_TRUE(y[1] >= 0 && y[1] < 2e-38f);
    EXPECT_TRUE(y[2] > 1e38f && std::isfinite(y[2]));
    EXPECT_TRUE(y[3] >= 0 && y[3] < 2e-38f);
}

TEST(Lanes, ElementByElement) {
    const Lanes a{-1.5f, 2.5f, -0.4f, 7}, b{1, 2, -3, 8};
    const Lanes min = Min(a, b), max = Max(a, b), abs = Abs(a), round = Round(a),
                root = Sqrt(b * b);
    for (int l = 0; l < 4; ++l) {
        EXPECT_EQ(min[l], std::min(a[l], b[l]));
        EXPECT_EQ(max[l], std::max(a[l], b[l]));
        EXPECT_EQ(abs[l], std::abs(a[l]));
        EXPECT_EQ(round[l], std::nearbyint(a[l]));
        EXPECT_EQ(root[l], std::abs(b[l]));
    }
    EXPECT_EQ(SumOf(b), 8);
}

}  // namespace
}  // namespace pbrt
