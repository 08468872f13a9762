#include "pbrt/util/math.h"

#include <gtest/gtest.h>

#include <numbers>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

TEST(Math, SinCosTurnsWithinStatedError) {
    double worst = 0;
    const auto check = [&](float turns) {
        const SinCos s = SinCosTurns(turns);
        const double angle = 2 * std::numbers::pi * double(turns);
        worst =
            std::max({worst, std::abs(s.sin - std::sin(angle)), std::abs(s.cos - std::cos(angle))});
        EXPECT_NEAR(s.sin * s.sin + s.cos * s.cos, 1, 3e-7);
    };
    for (int i = -200000; i <= 200000; ++i)
        check(float(i) / 100000);
    check(1000.123f);
    check(-0x1p20f);
    EXPECT_LT(worst, 1.5e-7);
    EXPECT_EQ(SinCosTurns(0.25f).sin, 1);
    EXPECT_EQ(SinCosTurns(0.f).sin, 0);
}

TEST(Math, PolynomialByHornersRule) {
    EXPECT_EQ(EvaluatePolynomial(2.f, 1.f, 10.f, 100.f), 421);
    EXPECT_EQ(EvaluatePolynomial(2.f, 7.f), 7);
}

TEST(Math, MortonCodeAndReversal) {
    Rng rng(4);
    for (int i = 0; i < 1000; ++i) {
        const uint32_t x = rng.Below(1 << 16), y = rng.Below(1 << 16);
        uint32_t code = 0, reversed = 0;
        const uint32_t z = rng.Next32();
        for (int b = 0; b < 16; ++b)
            code |= ((x >> b & 1) << (2 * b)) | ((y >> b & 1) << (2 * b + 1));
        for (int b = 0; b < 32; ++b)
            reversed |= (z >> b & 1) << (31 - b);
        EXPECT_EQ(EncodeMorton2(x, y), code);
        EXPECT_EQ(ReverseBits32(z), reversed);
    }
}

}  // namespace
}  // namespace pbrt
