#include "pbrt/util/alias_table.h"

#include <gtest/gtest.h>

#include <array>

namespace pbrt {
namespace {

TEST(AliasTable, ShareOfTheUnitIntervalIsTheProbability) {
    const std::array<float, 7> weights{3, 0, 1e-3f, 8, 0.5f, 0, 2};
    const AliasTable table(weights);
    const int n = 1 << 16;
    std::array<double, 7> share{};
    for (int i = 0; i < n; ++i) {
        const auto s = table.Sample((float(i) + 0.5f) / n);
        ASSERT_GT(weights[size_t(s.index)], 0);
        EXPECT_EQ(s.pmf, table.PMF(s.index));
        EXPECT_GE(s.u, 0);
        EXPECT_LT(s.u, 1);
        share[size_t(s.index)] += 1.0 / n;
    }
    for (size_t i = 0; i < weights.size(); ++i) {
        EXPECT_NEAR(share[i], table.PMF(int(i)), 14.0 / n);
        EXPECT_FLOAT_EQ(table.PMF(int(i)), weights[i] / 13.501f);
    }
}

/// What is left of the number is uniform: within each slot's two parts it runs from 0 to 1.
TEST(AliasTable, LeftoverIsUniform) {
    const AliasTable table(std::array<float, 5>{1, 2, 3, 4, 5});
    const int n = 1 << 15;
    std::array<double, 5> sum{}, squares{}, count{};
    for (int i = 0; i < n; ++i) {
        const auto s = table.Sample((float(i) + 0.5f) / n);
        const size_t k = size_t(s.index);
        sum[k] += s.u, squares[k] += Sqr(s.u), ++count[k];
    }
    for (size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(sum[k] / count[k], 0.5, 1e-3);
        EXPECT_NEAR(squares[k] / count[k], 1.0 / 3, 1e-3);
    }
}

TEST(AliasTable, NothingButZerosIsUniform) {
    const AliasTable table(std::array<float, 4>{0, 0, 0, 0});
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(table.PMF(i), 0.25f);
        EXPECT_EQ(table.Sample(float(i) / 4).index, i);
    }
}

}  // namespace
}  // namespace pbrt
