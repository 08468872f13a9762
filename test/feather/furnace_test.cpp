// What a vane returns when its film is a perfect mirror, MODEL section 8: figures of a ray tracer
// of true ellipses, first bounce only.

#include <gtest/gtest.h>

#include "feather/model.h"

namespace pbrt::feather {
namespace {

/// Shares of the light from w: mirrored into a direction that is not hidden, and passed.
struct Shares {
    double reflected = 0, passed = 0;
};

Shares FirstBounce(const Shape &shape, Direction<double> w, int segments = 16, int points = 4000) {
    const Row<double> row = RowOf<double>(shape);
    const Bend<double> bend = BendOf<double>(shape);
    Shares shares;
    for (int i = 0; i < segments; ++i) {
        const Segment<double> a = bend.Sample(w, (i + 0.5) / segments);
        const RowView<double> seen = row.SeenFrom(a.Across(w));
        shares.passed += seen.Gap() / segments;
        int lit = 0;
        for (int j = 0; j < points; ++j) {
            const double q = seen.lower + (seen.upper - seen.lower) * (j + 0.5) / points;
            const Direction<double> m = NormalAt(row, a, seen.PointAt(q));
            const double twice = 2 * Dot(m, w);
            const Direction<double> wi{twice * m.x - w.x, twice * m.y - w.y, twice * m.z - w.z};
            lit += Sees(row, bend, wi, FacetWithNormal(row, m, 1.0));
        }
        shares.reflected += (1 - seen.Gap()) * lit / (double(segments) * points);
    }
    return shares;
}

TEST(Furnace, MirrorFilmReturnsWhatTracingReturns) {
    struct Row {
        Shape shape;
        double gamma, passed, reflected;
    };
    const Shape tilted{.tilt = -0.8}, sparse{.spacing = 2.5}, round{.aspect = 1},
        dense{.spacing = 0.5};
    const Row table[] = {
        {{}, -75, 0, .9893},       {{}, -25, 0, .9868},        {{}, 0, 0, .8760},
        {{}, 25, 0, .7507},        {{}, 50, 0, .5843},         {{}, 75, 0, .5145},
        {tilted, 0, 0, .3943},     {tilted, 25, .2861, .3573}, {tilted, 50, .3312, .3974},
        {sparse, 0, .2454, .6671}, {sparse, 50, .4844, .4019}, {round, 0, 0, .9187},
        {round, 50, 0, .9128},     {{}, 60, .0375, .5257},     {dense, 0, 0, 1},
        {dense, 60, 0, .938}};
    for (const Row &row : table) {
        // The tracer's rows are straight: the least opening.
        Shape straight = row.shape;
        straight.opening = 0;
        const Direction<double> w = Spherical(row.gamma, 0);
        const Shares shares = FirstBounce(straight, w);
        EXPECT_NEAR(shares.passed, row.passed, 6e-5) << row.shape << " gamma " << row.gamma;
        EXPECT_NEAR(shares.reflected, row.reflected, 4e-4) << row.shape << " gamma " << row.gamma;
        EXPECT_NEAR(BarbuleOf<double>(straight).GapFraction(w), row.passed, 6e-5);
        EXPECT_NEAR(FirstBounce(row.shape, w).reflected, row.reflected, 1e-3) << row.shape;
    }
}

// True film, along the barbule at 80 degrees: the published code returns 1.29.
TEST(Furnace, TrueFilmAtEightyDegreesAlongTheBarbule) {
    const auto barbule = BarbuleOf<double>({});
    const auto view = barbule.SeenFrom(Spherical(80, 90));
    double sum = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const auto s = barbule.Sample_f(view, (i + 0.5) / n, std::fmod(i * 0.7548776662466927, 1),
                                        std::fmod(i * 0.5698402909980532, 1));
        if (s)
            for (double f : s->f)
                sum += f * std::abs(s->wi.z) / s->pdf / (4.0 * n);
    }
    EXPECT_LE(sum, 1);
    EXPECT_GT(sum, 0.2);
}

// An uneven film over melanin that reflects everything, towards grazing incidence: R and TRT take
// different means of the film, and must not add up to more than there is.
TEST(Furnace, RoughFilmMakesNoEnergy) {
    auto optics = Feather<double>();
    optics.melanin.fill(1);
    for (double roughness : {5., 15., 40.})
        for (double theta : {85., 88., 89.9})
            for (double phi : {0., 60., 90.}) {
                const auto barbule = BarbuleOf<double>(Shape{.roughness = roughness}, optics);
                const auto view = barbule.SeenFrom(Spherical(theta, phi));
                std::array<double, 4> light{};
                const int n = 20000;
                for (int i = 0; i < n; ++i) {
                    const auto s =
                        barbule.Sample_f(view, (i + 0.5) / n, std::fmod(i * 0.7548776662466927, 1),
                                         std::fmod(i * 0.5698402909980532, 1));
                    if (!s) continue;
                    for (std::size_t k = 0; k < 4; ++k)
                        light[k] += s->f[k] * std::abs(s->wi.z) / s->pdf / n;
                }
                // Evenly drawn: the sum's own error is some 1e-3.
                for (double share : light)
                    EXPECT_LE(share, 1.002) << roughness << " nm, " << theta << ", " << phi;
            }
}

}  // namespace
}  // namespace pbrt::feather
