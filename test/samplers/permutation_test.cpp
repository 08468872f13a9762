#include "pbrt/samplers/permutation.h"

#include <gtest/gtest.h>

#include <vector>

#include "pbrt/util/rng.h"

namespace pbrt {
namespace {

TEST(Permutation, HitsEveryElementOnce) {
    Rng rng(1);
    for (uint32_t n = 1; n < 300; n = n < 20 ? n + 1 : n * 3 / 2) {
        const Permutation permutation(n);
        for (int key = 0; key < 50; ++key) {
            const uint32_t walk = rng.Next32(), turn = rng.Next32();
            std::vector<bool> seen(n);
            for (uint32_t i = 0; i < n; ++i) {
                const uint32_t p = permutation(i, walk, turn);
                ASSERT_LT(p, n);
                EXPECT_FALSE(seen[p]);
                seen[p] = true;
            }
        }
    }
}

/// Each place equally likely (5 standard deviations); the chance of each pair of neighbours within
/// 20 % rms.
TEST(Permutation, PlacesAreUniform) {
    Rng rng(2);
    for (uint32_t n : {2u, 3u, 4u, 5u, 9u, 16u}) {
        const Permutation permutation(n);
        const int trials = 30000 * int(n);
        std::vector<int> place(n), pair(n * n);
        for (int t = 0; t < trials; ++t) {
            const uint32_t walk = rng.Next32(), turn = rng.Next32();
            const uint32_t a = permutation(0u, walk, turn), b = permutation(1u, walk, turn);
            ++place[a];
            ++pair[a * n + b];
        }
        const double mean = trials / double(n), pairs = mean / (n - 1);
        for (int count : place)
            EXPECT_NEAR(count, mean, 5 * std::sqrt(mean)) << n;
        double squares = 0;
        for (uint32_t i = 0; i < n * n; ++i) {
            if (i % (n + 1) != 0) squares += (pair[i] - pairs) * (pair[i] - pairs);
        }
        const double variance = squares / (n * (n - 1)) - pairs;  // beyond counting noise
        EXPECT_LT(std::sqrt(std::max(0.0, variance)), 0.2 * pairs) << n;
    }
}

/// Variance of sum w_a(p(i)) w_b(q(i)) over n points, relative to independent ones, for random
/// permutations p and q: n / (n - 1), where w are Walsh functions other than 1.
TEST(BitPermutation, DimensionsAreAsIndependentAsRandomPermutationsMakeThem) {
    Rng rng(3);
    for (int bits = 1; bits <= 6; ++bits) {
        const uint32_t n = uint32_t(1) << bits;
        const BitPermutation permutation(bits);
        const int trials = 4000;
        for (uint32_t a = 1; a < n; a = 2 * a + a % 3) {
            for (uint32_t b = 1; b < n; b = 2 * b + b % 3) {
                double squares = 0;
                for (int t = 0; t < trials; ++t) {
                    const uint32_t keyP = rng.Next32(), keyQ = rng.Next32();
                    int sum = 0;
                    for (uint32_t i = 0; i < n; ++i) {
                        const uint32_t p = permutation(i, keyP), q = permutation(i, keyQ);
                        sum += std::popcount((p & a) ^ (q & b) << 16) % 2 ? -1 : 1;
                    }
                    squares += sum * sum;
                }
                // The square of a sum has variance 2 at most, so 5 deviations are 0.11.
                EXPECT_NEAR(squares / trials / n, n / (n - 1.0), 0.2 + 0.11) << a << " " << b;
            }
        }
    }
}

}  // namespace
}  // namespace pbrt
