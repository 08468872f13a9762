#include <gtest/gtest.h>

#include "feather/model.h"
#include "support/chi_square.h"
#include "support/quadrature.h"

namespace pbrt::feather {
namespace {

constexpr int kTheta = 80, kPhi = 160, kDraws = 1000000;

struct Case {
    Shape shape;
    Direction<double> wo;
};

const std::vector<Case> kCases{
    {{}, Spherical(0, 0)},
    {{}, Spherical(60, 0)},
    {{}, Spherical(70, 120)},
    {{.aspect = 1}, Spherical(45, 30)},
    {{.spacing = 2.5}, Spherical(30, 10)},
    {{.spacing = 2.5}, -Spherical(50, 45)},
    {{.spacing = 0.3}, Spherical(40, 200)},
    {{.tilt = -0.8}, Spherical(50, 5)},
    {{.tilt = 0.3}, Spherical(80, 80)},
    {{.opening = 0.1571}, Spherical(87, 95)},
    {{.spacing = 2.5, .tilt = -0.8, .opening = 0.9}, Spherical(65, 60)},
    {{.spacing = 3, .tilt = 0.5, .aspect = 2, .opening = 1.4}, -Spherical(75, 100)},
};

/// Counts of draws by bin of theta and phi; the last bin is the gap.
template <std::floating_point T>
std::vector<double> Counts(const Case &c, int seed) {
    std::vector<double> counts(kTheta * kPhi + 1, 0);
    const auto barbule = BarbuleOf<T>(c.shape);
    const auto view = barbule.SeenFrom(Rounded<T>(c.wo));
    Dice dice(seed);
    for (int k = 0; k < kDraws; ++k) {
        const T uc = T(dice.Uniform()), u0 = T(dice.Uniform()), u1 = T(dice.Uniform());
        const auto s = barbule.SampleDirection(view, std::min(uc, T(0.99999994)),
                                               std::min(u0, T(0.99999994)), u1);
        if (!s) continue;
        if (s->isGap) {
            ++counts.back();
            continue;
        }
        const double theta = std::acos(std::clamp(double(s->wi.z), -1., 1.));
        double phi = std::atan2(double(s->wi.y), double(s->wi.x));
        if (phi < 0) phi += 2 * std::numbers::pi;
        const int i = std::min(kTheta - 1, int(theta / std::numbers::pi * kTheta));
        const int j = std::min(kPhi - 1, int(phi / (2 * std::numbers::pi) * kPhi));
        ++counts[i * kPhi + j];
    }
    return counts;
}

std::vector<double> Expected(const Case &c) {
    std::vector<double> expected;
    const auto barbule = BarbuleOf<double>(c.shape);
    const auto view = barbule.SeenFrom(c.wo);
    const auto density = [&](double theta, double phi) {
        const double s = std::sin(theta);
        return kDraws * s *
               barbule.PDF(view, {s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
    };
    for (int i = 0; i < kTheta; ++i)
        for (int j = 0; j < kPhi; ++j)
            expected.push_back(test::IntegrateAdaptively(
                density,
                {i * std::numbers::pi / kTheta, (i + 1) * std::numbers::pi / kTheta,
                 j * 2 * std::numbers::pi / kPhi, (j + 1) * 2 * std::numbers::pi / kPhi},
                1, 4));
    expected.push_back(kDraws * (1 - view.pigmentChance) * barbule.GapFraction(c.wo));
    return expected;
}

// Significance 0.01 for the whole set of cases (Sidak); seeds are fixed.
TEST(Sampling, DrawsWhatThePdfSays) {
    const double significance = test::Sidak(0.01, 2 * int(kCases.size()));
    for (std::size_t k = 0; k < kCases.size(); ++k) {
        const std::vector<double> expected = Expected(kCases[k]);
        for (const auto &counts :
             {Counts<double>(kCases[k], 100 + k), Counts<float>(kCases[k], 200 + k)}) {
            const test::ChiSquare result = test::TestCounts(counts, expected);
            EXPECT_GT(result.pValue, significance)
                << kCases[k].shape << " chi2 " << result.statistic << " of "
                << result.degreesOfFreedom;
            EXPECT_GT(result.degreesOfFreedom, 300);
        }
    }
}

}  // namespace
}  // namespace pbrt::feather
