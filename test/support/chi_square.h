#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pbrt::test {

/// Result of a chi-square test: the probability of a statistic as large by chance.
struct ChiSquare {
    double statistic, pValue;
    int degreesOfFreedom;
};

/// Pearson's test of counts against expected counts (any number of bins). Bins that expect fewer
/// than `pool` are taken together, smallest first, until each group expects that many.
/// The p-value is Wilson and Hilferty's normal approximation, better than 1e-3 from 30 degrees of
/// freedom.
inline ChiSquare TestCounts(const std::vector<double> &counts, const std::vector<double> &expected,
                            double pool = 5) {
    std::vector<int> order(expected.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return expected[a] < expected[b]; });
    ChiSquare test{0, 1, -1};
    double groupCount = 0, groupExpected = 0;
    for (int i : order) {
        groupCount += counts[i];
        groupExpected += expected[i];
        if (groupExpected < pool) continue;
        const double off = groupCount - groupExpected;
        test.statistic += off * off / groupExpected;
        ++test.degreesOfFreedom;
        groupCount = groupExpected = 0;
    }
    const double k = std::max(1, test.degreesOfFreedom);
    const double z = (std::cbrt(test.statistic / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
    test.pValue = std::erfc(z / std::sqrt(2.0)) / 2;
    return test;
}

/// The significance of each of `tests` tests that together are wrong with probability `overall`.
inline double Sidak(double overall, int tests) {
    return 1 - std::pow(1 - overall, 1.0 / tests);
}

}  // namespace pbrt::test
