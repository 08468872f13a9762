#include "pbrt/util/atan2.h"

#include <gtest/gtest.h>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

TEST(FastAtan2, IsNearAtan2) {
    Rng rng(1);
    for (int i = 0; i < 1000000; ++i) {
        const float scale = std::pow(10.f, 30 * rng.Uniform() - 15);
        float y = scale * (2 * rng.Uniform() - 1), x = scale * (2 * rng.Uniform() - 1);
        if (i % 4 == 0) y *= std::pow(10.f, -10 * rng.Uniform());
        const double expected = std::atan2(double(y), double(x));
        const double error = std::abs(FastAtan2(y, x) - expected);
        EXPECT_LT(error, 4e-7) << y << " " << x;
        EXPECT_TRUE(x < std::abs(y) || error <= 3e-7 * std::abs(expected)) << y << " " << x;
    }
}

TEST(FastAtan2, OnTheAxes) {
    EXPECT_EQ(FastAtan2(0.f, 0.f), 0);
    EXPECT_EQ(FastAtan2(0.f, 2.f), 0);
    EXPECT_EQ(FastAtan2(0.f, -2.f), Pi);
    EXPECT_EQ(FastAtan2(3.f, 0.f), Pi / 2);
    EXPECT_EQ(FastAtan2(-3.f, 0.f), -Pi / 2);
    EXPECT_EQ(FastAtan2(1.f, 1.f), Pi / 4);
}

}  // namespace
}  // namespace pbrt
