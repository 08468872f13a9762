#include "pbrt/feather/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pbrt::feather {
namespace {

// Leertouwer et al. 2011, as quoted in the project's list of physical facts.
TEST(Dispersion, KeratinIsLeertouwers) {
    EXPECT_NEAR(KeratinIndex(Nm<double>{400}), 1.569, 5e-4);
    EXPECT_NEAR(KeratinIndex(Nm<double>{500}), 1.556, 5e-4);
    EXPECT_NEAR(KeratinIndex(Nm<double>{600}), 1.548, 5e-4);
}

// S-sec.2: after 2 um of melanin 6.7 % of the light is left.
TEST(Dispersion, MelaninAbsorbsAsStavengaMeasured) {
    const auto [n, k] = MelaninIndex(Nm<double>{589});
    EXPECT_NEAR(n, 1.716, 5e-4);
    EXPECT_NEAR(k, 0.0632, 5e-5);
    const double alpha = 4 * std::numbers::pi * k / 589;
    EXPECT_NEAR(alpha, 0.001349, 5e-7);
    EXPECT_NEAR(std::exp(-alpha * 2000), 0.067, 5e-4);
}

TEST(Dispersion, MelaninReflectanceAtNormalIncidence) {
    constexpr double expected[] = {.0830, .0779, .0743, .0716, .0697, .0681, .0669};
    for (int i = 0; i < 7; ++i)
        EXPECT_NEAR(MelaninReflectance(Nm<double>{400. + 50 * i}), expected[i], 5.1e-5);
}

}  // namespace
}  // namespace pbrt::feather
