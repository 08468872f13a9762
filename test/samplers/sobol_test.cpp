#include "pbrt/samplers/sobol.h"

#include <gtest/gtest.h>

#include <bit>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

/// By the direction numbers of the primitive polynomial x + 1: v[0] = 1/2, v[j] = v[j-1] xor
/// v[j-1] / 2.
uint32_t SobolY(uint32_t i) {
    uint32_t direction = uint32_t(1) << 31, y = 0;
    for (; i != 0; i >>= 1) {
        if (i & 1) y ^= direction;
        direction ^= direction >> 1;
    }
    return y;
}

TEST(Sobol, ButterflyIsTheGeneratorMatrix) {
    Rng rng(1);
    for (int i = 0; i < 10000; ++i) {
        const uint32_t index = rng.Next32();
        EXPECT_EQ(ReverseBits32(SobolYReversed(index)), SobolY(index));
    }
}

using Scramble = uint32_t (*)(uint32_t, uint32_t);

class Owen : public testing::TestWithParam<Scramble> {};

/// Two numbers that agree in their first k digits do so after scrambling, and differ in the next if
/// they did.
TEST_P(Owen, IsNested) {
    Rng rng(2);
    for (int i = 0; i < 20000; ++i) {
        const uint32_t a = rng.Next32(), seed = rng.Next32();
        const int k = int(rng.Below(32));
        const uint32_t other = rng.Next32() << k << 1;  // what follows digit k is arbitrary
        const uint32_t b = (a ^ (uint32_t(1) << k)) ^ other;
        EXPECT_EQ(std::countr_zero(GetParam()(a, seed) ^ GetParam()(b, seed)), k);
    }
}

/// Each digit is flipped in half the seeds, whatever the number; 4.5 standard deviations.
TEST_P(Owen, FlipsEachDigitHalfTheTime) {
    Rng rng(3);
    const int n = 4000;
    for (uint32_t v : {0u, 1u, 0x55555555u, 0xffffffffu, 0x80000001u, 12345u}) {
        for (int digit = 0; digit < 24; ++digit) {
            int flips = 0;
            for (int i = 0; i < n; ++i)
                flips += int((GetParam()(v, Mix32(rng.Next32())) ^ v) >> digit & 1);
            EXPECT_NEAR(flips, n / 2, 4.5 * std::sqrt(n) / 2) << v << " digit " << digit;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sobol, Owen,
                         testing::Values(OwenReversed<uint32_t>, FastOwenReversed<uint32_t>));

}  // namespace
}  // namespace pbrt
