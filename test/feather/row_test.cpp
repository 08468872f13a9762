#include "pbrt/feather/row.h"

#include <gtest/gtest.h>

#include "feather/model.h"

namespace pbrt::feather {
namespace {

/// Whether the beam towards u meets the unit circle at c before it has left p behind; p may be on
/// the circle's rim.
bool Hides(Planar<double> c, Planar<double> p, Planar<double> u) {
    const Planar<double> to{c.n - p.n, c.x - p.x};
    const double along = Dot(to, u), across = Cross(u, to);
    return across * across < 1 && along + std::sqrt(1 - across * across) > 1e-12;
}

/// The row itself: which points of a circle can be left towards u, with all neighbours that reach.
bool SeenByTracing(const Shape &s, Planar<double> w, double q) {
    const double c = std::cos(s.tilt), n = std::sin(s.tilt);
    const Planar<double> image{(c * w.n + n * w.x) / s.aspect, c * w.x - n * w.n};
    const Planar<double> step{s.spacing * n / s.aspect, s.spacing * c};
    const double h = std::hypot(image.n, image.x);
    const Planar<double> u{image.n / h, image.x / h};
    const double along = std::sqrt(1 - q * q);
    const Planar<double> p{along * u.n - q * u.x, along * u.x + q * u.n};
    const double across = std::abs(Cross(u, step));
    const int reach = int(std::min(2 / across, 1e4)) + 2;
    for (int j = -reach; j <= reach; ++j)
        if (j != 0 && Hides({j * step.n, j * step.x}, p, u)) return false;
    return true;
}

Planar<double> InPlane(double degrees) {
    const double g = degrees * std::numbers::pi / 180;
    return {std::cos(g), std::sin(g)};
}

TEST(Row, SeesWhatTracingSees) {
    Dice dice(10);
    int wrong = 0, points = 0;
    for (int k = 0; k < 3000; ++k) {
        const Shape s = dice.AnyShape();
        const Planar<double> w = InPlane(dice.Uniform(-180, 180));
        const RowView<double> seen = RowOf<double>(s).SeenFrom(w);
        for (int i = 0; i < 40; ++i, ++points) {
            const double q = dice.Uniform(-1, 1), lower = seen.lower / seen.reach,
                         upper = seen.upper / seen.reach;
            const bool inside = q >= lower && q <= upper;
            const double edge = std::min(std::abs(q - lower), std::abs(q - upper));
            if (edge > 1e-9 && inside != SeenByTracing(s, w, q)) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << points;
}

TEST(Row, GapAndVisibleAreAll) {
    Dice dice(11);
    for (int k = 0; k < 100000; ++k) {
        const Shape s = dice.AnyShape();
        const RowView<double> seen = RowOf<double>(s).SeenFrom(InPlane(dice.Uniform(-180, 180)));
        EXPECT_NEAR(seen.Gap() + (seen.upper - seen.lower) / seen.shift, 1, 1e-11) << s;
        EXPECT_LE(seen.lower, seen.upper);
        EXPECT_GE(seen.lower, -seen.reach * (1 + 1e-12));
        EXPECT_LE(seen.upper, seen.reach * (1 + 1e-12));
    }
}

TEST(Row, TurnedByPiItIsTheSame) {
    Dice dice(12);
    for (int k = 0; k < 10000; ++k) {
        const Row<double> row = RowOf<double>(dice.AnyShape());
        const Planar<double> w = InPlane(dice.Uniform(-180, 180));
        const RowView<double> a = row.SeenFrom(w), b = row.SeenFrom({-w.n, -w.x});
        EXPECT_EQ(a.Gap(), b.Gap());
        EXPECT_EQ(a.lower, b.lower);
        EXPECT_EQ(a.upper, b.upper);
    }
}

TEST(Row, OpensWhereTheGapBegins) {
    Dice dice(13);
    int open = 0;
    for (int k = 0; k < 100000; ++k) {
        const Row<double> row = RowOf<double>(dice.AnyShape());
        const Planar<double> w = InPlane(dice.Uniform(-180, 180));
        const Interval<double> range = row.Open(std::abs(w.x), w.n * w.x);
        const RowView<double> seen = row.SeenFrom(w);
        const double n = std::abs(w.n), shift = seen.shift / seen.reach;
        if (std::abs(shift - 2) < 1e-9) continue;
        EXPECT_EQ(n > range.lo && n<range.hi, shift> 2);
        open += shift > 2;
    }
    EXPECT_GT(open, 10000);
}

TEST(Row, TouchingBarbulesAreClosed) {
    const Row<double> row(2, {0}, 0.25);
    EXPECT_TRUE(row.Closed());
    for (int g = -89; g < 90; ++g)
        EXPECT_EQ(row.SeenFrom(InPlane(g)).Gap(), 0) << g;
    EXPECT_FALSE(Row<double>(2.0001, {0}, 0.25).Closed());
}

TEST(Row, AlongTheBarbuleNothingIsSeen) {
    const RowView<float> seen = RowOf<float>({}).SeenFrom({0, 0});
    EXPECT_EQ(seen.Gap(), 0);
    EXPECT_EQ(seen.upper - seen.lower, 0);
}

}  // namespace
}  // namespace pbrt::feather
