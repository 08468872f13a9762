#include "pbrt/feather/bend.h"

#include <gtest/gtest.h>

#include "feather/model.h"
#include "pbrt/feather/gap.h"

namespace pbrt::feather {
namespace {

/// The direction at 0 to 89.99 degrees from the normal, above or below.
Direction<double> AnyDirection(Dice &dice) {
    const double theta =
        dice.Uniform() < 0.5 ? dice.Uniform(0, 89.99) : 90 - dice.LogUniform(0.01, 10);
    const Direction<double> w = Spherical(theta, dice.Uniform(0, 360));
    return dice.Uniform() < 0.5 ? w : -w;
}

// The weights |w.z_a| / |w.z| da / (2 sin opening) over what w sees of the arc.
TEST(Bend, SegmentWeightsSumToOne) {
    Dice dice(20);
    for (int k = 0; k < 2000; ++k) {
        const Bend<double> bend(Radian<double>{dice.LogUniform(0.002, 1.5)});
        const Direction<double> w = AnyDirection(dice);
        const auto [lo, hi] = bend.SeenFrom(w);
        double sum = 0;
        const auto &rule = kGaussLegendre<double, 16>;
        for (int i = 0; i < 16; ++i) {
            const double a = (lo + hi) / 2 + (hi - lo) / 2 * rule.node[i];
            const double cosine = w.y * std::sin(a) + w.z * std::cos(a);
            EXPECT_GE(cosine * w.z, 0);
            sum += rule.weight[i] * (hi - lo) / 2 * std::abs(cosine / w.z);
        }
        EXPECT_NEAR(sum / (2 * bend.SinOpening()), 1, 1e-10);
    }
}

TEST(Bend, SeesItsRangeAndSamplesIt) {
    Dice dice(21);
    for (int k = 0; k < 20000; ++k) {
        const Bend<double> bend(Radian<double>{dice.LogUniform(0.002, 1.5)});
        const Direction<double> w = AnyDirection(dice);
        const auto [lo, hi] = bend.SeenFrom(w);
        const double a = dice.Uniform(-1.57, 1.57);
        if (std::min(std::abs(a - lo), std::abs(a - hi)) > 1e-9) {
            EXPECT_EQ(bend.Sees(w, {std::sin(a), std::cos(a)}), a > lo && a < hi);
        }
        const Segment<double> drawn = bend.Sample(w, dice.Uniform());
        EXPECT_NEAR(drawn.sin * drawn.sin + drawn.cos * drawn.cos, 1, 1e-12);
        EXPECT_GE(std::asin(drawn.sin), lo - 1e-7);
        EXPECT_LE(std::asin(drawn.sin), hi + 1e-7);
    }
}

TEST(Bend, SampleFollowsTheWeights) {
    const Bend<double> bend(Radian<double>{0.8});
    for (const Direction<double> w : {Spherical(30, 70), Spherical(80, 95), -Spherical(85, 80)}) {
        for (double u : {0.1, 0.5, 0.9}) {
            const Segment<double> drawn = bend.Sample(w, u);
            const double nearest = Bend<double>::Side(w) * std::asin(drawn.sin);
            double share = 0;  // of the weights from the end nearest w
            const int n = 2000;
            for (int i = 0; i < n; ++i) {
                const double a = nearest + (0.8 - nearest) * (i + 0.5) / n;
                share += std::abs(w.y) * std::sin(a) + std::abs(w.z) * std::cos(a);
            }
            share *= (0.8 - nearest) / n / (2 * bend.SinOpening() * std::abs(w.z));
            EXPECT_NEAR(share, u, 1e-6);
        }
    }
}

// MODEL 4.3 and 5: T(w) and the projected area of the facets that w sees are all there is. The
// facets are found by their normals alone, over all azimuths, at equal steps of the eccentric
// angle.
TEST(BentRow, GapAndVisibleFacetsAreAll) {
    Dice dice(22);
    for (int k = 0; k < 40; ++k) {
        const Shape s = dice.AnyShape();
        const Row<double> row = RowOf<double>(s);
        const Bend<double> bend = BendOf<double>(s);
        const Direction<double> w = AnyDirection(dice);
        const auto [lo, hi] = bend.SeenFrom(w);
        const int na = 100, ne = 6000;
        double facets = 0;
        for (int i = 0; i < na * ne; ++i) {
            const double a = lo + (hi - lo) * (i / ne + 0.5) / na;
            const double shift = std::fmod(i / ne * 0.6180339887498949, 1);  // of the grid in e
            const double e = 2 * std::numbers::pi * (i % ne + shift) / ne;
            const double n = std::cos(e), x = s.aspect * std::sin(e);
            const double gamma = s.tilt + std::atan2(x, n);
            const Direction<double> m{std::sin(gamma), std::cos(gamma) * std::sin(a),
                                      std::cos(gamma) * std::cos(a)};
            const Facet<double> facet = FacetWithNormal(row, m, 1.0);
            if (!Sees(row, bend, w, facet)) continue;
            const double dm = std::abs(std::cos(gamma)) * s.aspect / (n * n + x * x);  // by da de
            facets += FacetDensity(row, bend, facet) * Dot(m, w) / std::abs(w.z) * dm;
        }
        facets *= (hi - lo) / na * 2 * std::numbers::pi / ne;
        EXPECT_NEAR(facets + GapFraction(row, bend, w), 1, 1e-3)
            << s << " w " << w.x << " " << w.y << " " << w.z;
    }
}

TEST(BentRow, GapFractionIsTheMeanOverTheArc) {
    Dice dice(23);
    for (int k = 0; k < 1000; ++k) {
        const Shape s = dice.AnyShape();
        const Row<double> row = RowOf<double>(s);
        const Bend<double> bend = BendOf<double>(s);
        const Direction<double> w = AnyDirection(dice);
        double mean = 0;
        const int n = 2000;
        for (int i = 0; i < n; ++i)
            mean += row.SeenFrom(bend.Sample(w, (i + 0.5) / n).Across(w)).Gap() / n;
        EXPECT_NEAR(GapFraction(row, bend, w), mean, 1e-3) << s;
        EXPECT_EQ(GapFraction(row, bend, w), GapFraction(row, bend, -w));
    }
}

}  // namespace
}  // namespace pbrt::feather
