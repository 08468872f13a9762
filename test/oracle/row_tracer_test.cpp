#include "oracle/row_tracer.h"

#include <gtest/gtest.h>

namespace pbrt::oracle {
namespace {

constexpr double kStraight = 1e-3;  // an opening that counts as none

const DirectionBins kOneBin({}, 1, 1);

Vec3 AcrossBarbules(double degrees) {
    const double gamma = degrees * std::numbers::pi / 180;
    return {std::sin(gamma), 0, std::cos(gamma)};
}

RowLight TraceMirror(const BentRow &row, Vec3 w, std::uint64_t seed, int samples) {
    const PerfectMirror mirror;
    return RowTracer(row, mirror, kOneBin, kOneBin).Trace(w, {seed, samples, true});
}

void ExpectWithin(Estimate e, double expected, double tolerance) {
    EXPECT_LE(std::abs(e.mean - expected), tolerance + CriticalSigmas() * e.error)
        << e.mean << " +- " << e.error << " against " << expected;
}

// Circles of radius 1 at a distance H leave 1 - 2 / (H cos gamma) open.
TEST(RowTracer, FindsTheGapBetweenCircles) {
    for (const double degrees : {0, 30, 50, -70}) {
        const double c = std::cos(degrees * std::numbers::pi / 180);
        const BentRow row(4, 0.7, 1, kStraight);
        ExpectWithin(TraceMirror(row, AcrossBarbules(degrees), 1, 512).gap,
                     std::max(0.0, 1 - 2 / (4 * c)), 0);
    }
}

// The light that a convex cylinder alone meets is all away after one reflection, and its Lambertian
// surface sends all of it away. The neighbours, 100 half-widths off, are in the way of a hundredth.
TEST(RowTracer, LoneBarbuleKeepsNothing) {
    struct White : PerfectMirror {
        double Pigment(double, double) const { return 1; }
    };
    const BentRow row(100, -0.35, 0.25, 0.0785);
    const White white;
    const RowLight light =
        RowTracer(row, white, kOneBin, kOneBin).Trace(AcrossBarbules(80), {2, 1024});
    const double met = 1 - light.gap.mean;
    EXPECT_GT(met, 0.03);
    ExpectWithin(light.single, met, 0.01 * met);
    ExpectWithin(light.pigment, met, 0.01 * met);
}

// A cup's light from above or below, at any angle, goes somewhere once.
TEST(RowTracer, LosesNothing) {
    for (const double opening : {0.0785, 0.9, 1.5})
        for (const double degrees : {0.0, 60.0, 89.0})
            for (const double side : {1, -1}) {
                const double t = degrees * std::numbers::pi / 180;
                const Vec3 w{side * std::sin(t) * 0.6, side * std::sin(t) * 0.8,
                             side * std::cos(t)};
                const RowLight l = TraceMirror(BentRow(1.25, -0.35, 0.25, opening), w, 3, 256);
                EXPECT_NEAR(l.gap.mean + l.single.mean + l.second.mean + l.later.mean, 1, 1e-12);
            }
}

// The density of the points that light meets, over a part of the surface and over the rest, against
// what is met there.
TEST(RowTracer, LightFallsAsTheDensitySays) {
    const auto part = [](const BentRow &row, const BentRow::Hit &hit) {
        return hit.segment.sin > 0.4 && std::sin(row.EccentricAngle(hit)) > 0.2 ? 1 : 0;
    };
    const double opening = 0.9, cell = 4 * opening * std::numbers::pi;
    for (const double spacing : {0.7, 2.5})
        for (const Vec3 w : {Vec3{0, 0, 1}, Vec3{0.6, 0.48, 0.64}, Vec3{0.1, 0.7, std::sqrt(0.5)},
                             Vec3{0, 0.99, -std::sqrt(1 - 0.9801)}}) {
            const BentRow row(spacing, -0.35, 0.5, opening);
            std::mt19937_64 random(4);
            Replicates density(2), found(2);
            for (int replicate = 0; replicate < kReplicates; ++replicate) {
                EvenPoints<2> surface(random), light(random);
                for (int i = 0; i < 512; ++i) {
                    const auto [u, v] = surface.Next();
                    const double a = opening * (2 * u - 1), e = 2 * std::numbers::pi * v;
                    if (const auto hit = row.At({std::sin(a), std::cos(a)}, e))
                        density.Add(part(row, *hit), row.HitDensity(w, *hit) * cell);
                    const auto [x, y] = light.Next();
                    if (const auto hit = row.Enter(w, x, y)) found.Add(part(row, *hit), 1);
                }
                density.Close(512);
                found.Close(512);
            }
            ExpectSame(density[0], found[0], "rest");
            ExpectSame(density[1], found[1], "part");
        }
}

// MODEL section 8: a film that reflects everything. The figures are those of a straight row, so it
// is traced here; its "ray traced" column of T and R is good to 1e-4, the rest to the last digit.
TEST(RowTracer, WhatSingleScatteringLeavesOut) {
    struct Row {
        double spacing, tilt, aspect, degrees, gap, single, second, later;
    };
    constexpr Row table[] = {{1.25, -.35, .25, -75, 0, .9893, .011, 0},
                             {1.25, -.35, .25, -25, 0, .9868, .013, 0},
                             {1.25, -.35, .25, 0, 0, .8759, .048, .076},
                             {1.25, -.35, .25, 25, 0, .7507, .062, .187},
                             {1.25, -.35, .25, 50, 0, .5843, .113, .303},
                             {1.25, -.35, .25, 75, 0, .5146, .182, .304},
                             {1.25, -.8, .25, 0, 0, .3943, .295, .311},
                             {1.25, -.8, .25, 25, .2861, .3571, .188, .169},
                             {1.25, -.8, .25, 50, .3312, .3973, .122, .149},
                             {2.5, -.35, .25, 0, .2454, .6673, .077, .010},
                             {2.5, -.35, .25, 50, .4844, .4019, .104, .009},
                             {1.25, -.35, 1, 0, 0, .9187, .081, 0},
                             {1.25, -.35, 1, 50, 0, .9129, .087, 0}};
    std::uint64_t seed = 100;
    for (const Row &r : table) {
        SCOPED_TRACE(testing::Message() << "spacing " << r.spacing << " tilt " << r.tilt
                                        << " aspect " << r.aspect << " gamma " << r.degrees);
        const BentRow row(r.spacing, r.tilt, r.aspect, kStraight);
        const RowLight light = TraceMirror(row, AcrossBarbules(r.degrees), ++seed, 4096);
        ExpectWithin(light.gap, r.gap, 1e-4);
        ExpectWithin(light.single, r.single, 1e-4);
        ExpectWithin(light.second, r.second, 5e-4);
        ExpectWithin(light.later, r.later, 5e-4);
    }
}

}  // namespace
}  // namespace pbrt::oracle
