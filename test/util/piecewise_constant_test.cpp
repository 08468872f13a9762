#include "pbrt/util/piecewise_constant.h"

#include <gtest/gtest.h>

#include <array>

namespace pbrt {
namespace {

TEST(PiecewiseConstant1D, DrawIsTheInverseOfTheCumulatedFunction) {
    const std::array<float, 6> f{0, 1, 3, 0, 4, 0};
    const PiecewiseConstant1D dist(f);
    EXPECT_FLOAT_EQ(dist.Integral(), 8.f / 6);
    for (int i = 0; i < 4096; ++i) {
        const float u = float(i) / 4096;
        const auto s = dist.Sample(u);
        EXPECT_GT(f[size_t(s.step)], 0);
        EXPECT_FLOAT_EQ(s.pdf, f[size_t(s.step)] * 6 / 8);
        EXPECT_FLOAT_EQ(s.pdf, dist.PDF(s.x));
        EXPECT_NEAR(dist.Invert(s.x), u, 1e-6);
    }
    EXPECT_LT(dist.Sample(OneMinusEpsilon).x, 5.f / 6 + 1e-6f);
    EXPECT_EQ(dist.Sample(0).step, 1);
}

TEST(PiecewiseConstant1D, NothingButZerosIsUniform) {
    const PiecewiseConstant1D dist(std::array<float, 3>{0, 0, 0});
    EXPECT_EQ(dist.Integral(), 0);
    for (float u : {0.f, 0.3f, 0.99f, OneMinusEpsilon}) {
        EXPECT_NEAR(dist.Sample(u).x, u, 1e-6);
        EXPECT_EQ(dist.Sample(u).pdf, 1);
        EXPECT_NEAR(dist.Invert(u), u, 1e-6);
    }
}

TEST(PiecewiseConstant2D, DensityInverseAndIntegral) {
    const std::array<float, 12> f{1, 0, 2, 5, 0, 0, 0, 0, 3, 3, 0, 7};
    const PiecewiseConstant2D dist(f, 4, 3);
    EXPECT_FLOAT_EQ(dist.Integral(), 21.f / 12);
    const int n = 128;
    std::array<double, 12> share{};
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const Point2f u{(float(i) + 0.5f) / n, (float(j) + 0.5f) / n};
            const auto s = dist.Sample(u);
            const size_t cell = size_t(s.step.y * 4 + s.step.x);
            share[cell] += 1.0 / (n * n);
            EXPECT_FLOAT_EQ(s.pdf, f[cell] * 12 / 21);
            EXPECT_FLOAT_EQ(s.pdf, dist.PDF(s.p));
            EXPECT_NEAR(dist.Invert(s.p).x, u.x, 1e-6);
            EXPECT_NEAR(dist.Invert(s.p).y, u.y, 1e-6);
        }
    }
    for (size_t i = 0; i < f.size(); ++i)
        EXPECT_NEAR(share[i], f[i] / 21.f, 2.0 / n);
}

}  // namespace
}  // namespace pbrt
