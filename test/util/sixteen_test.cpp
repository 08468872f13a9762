// Sixteen at once are those one by one. The formulas are the same text; the compiler fuses
// multiplications and additions as it likes, so results differ by a few roundings of the largest
// term, which is about 1 here unless said otherwise.

#include <gtest/gtest.h>

#include "pbrt/util/equal_area.h"
#include "pbrt/util/piecewise_constant.h"
#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt {
namespace {

constexpr float kRoundings = 8 * 0x1p-24f;

/// Numbers in [0, 1), its ends and its middle among them.
Point2fX16 Numbers(Rng &rng) {
    constexpr float kCorners[] = {0, 0.5f, OneMinusEpsilon, 0x1p-24f};
    Point2fX16 u;
    for (int i = 0; i < kPacketSize; ++i) {
        const auto one = [&] { return rng.Below(8) == 0 ? kCorners[rng.Below(4)] : rng.Uniform(); };
        SetLane(&u, i, {one(), one()});
    }
    return u;
}
void ExpectNear(float a, float b, float tolerance = kRoundings) {
    EXPECT_NEAR(a, b, tolerance);
}
void ExpectNear(Point2f a, Point2f b, float tolerance = kRoundings) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}
void ExpectNear(Vector3f a, Vector3f b, float tolerance = kRoundings) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

template <typename Check>
void ForManyNumbers(Check check) {
    Rng rng(1);
    for (int round = 0; round < 1000; ++round)
        check(Numbers(rng));
}

TEST(SixteenAtOnce, Warps) {
    ForManyNumbers([](Point2fX16 u) {
        const Point2fX16 disk = SampleUniformDiskConcentric(u);
        const Vector3fX16 cosine = SampleCosineHemisphere(u), sphere = EqualAreaSquareToSphere(u);
        const Point2fX16 square = EqualAreaSphereToSquare(sphere);
        for (int i = 0; i < kPacketSize; ++i) {
            ExpectNear(Lane(disk, i), SampleUniformDiskConcentric(Lane(u, i)));
            // z is a root: at the rim roundings grow to their root.
            const Vector3f w = SampleCosineHemisphere(Lane(u, i));
            ExpectNear(Lane(cosine, i), w, std::min(1e-3f, kRoundings / std::max(w.z, 1e-7f)));
            ExpectNear(Lane(sphere, i), EqualAreaSquareToSphere(Lane(u, i)));
            ExpectNear(Lane(square, i), EqualAreaSphereToSquare(Lane(sphere, i)));
        }
    });
}

TEST(SixteenAtOnce, Angles) {
    ForManyNumbers([](Point2fX16 u) {
        const FloatX16 turns = 8 * u.x - 4, x = 2 * u.x - 1, y = 2 * u.y - 1;
        const SinCosT<FloatX16> wide = SinCosTurns(turns);
        const FloatX16 angle = FastAtan2(y, x);
        for (int i = 0; i < kPacketSize; ++i) {
            const SinCos one = SinCosTurns(turns[i]);
            ExpectNear(wide.sin[i], one.sin);
            ExpectNear(wide.cos[i], one.cos);
            ExpectNear(angle[i], FastAtan2(y[i], x[i]), 3 * kRoundings);
        }
    });
}

TEST(SixteenAtOnce, PowerHeuristic) {
    FloatX16 f, g;
    constexpr float kValues[] = {0, 1e-30f, 0.3f, 7, 1e10f, 1e30f};
    for (float a : kValues)
        for (float b : kValues) {
            if (a == 0 && b == 0) continue;
            f = a, g = b;
            const float wide = PowerHeuristic(f, g)[5], one = PowerHeuristic(a, b);
            if (one == one) ExpectNear(wide, one);
            EXPECT_EQ(wide == wide, one == one);
        }
}

/// Steps are found by comparison alone, so they are the same.
TEST(SixteenAtOnce, PiecewiseConstant2D) {
    Rng rng(3);
    for (const auto &[nu, nv] : {std::pair{1, 1}, {5, 3}, {16, 16}, {100, 33}}) {
        std::vector<float> f(size_t(nu * nv));
        for (float &v : f)
            v = rng.Below(3) == 0 ? 0 : rng.Uniform();
        const PiecewiseConstant2D distribution(f, nu, nv);
        ForManyNumbers([&](Point2fX16 u) {
            const PiecewiseConstant2D::PointSampleX16 wide = distribution.Sample(u);
            const FloatX16 pdf = distribution.PDF(u);
            for (int i = 0; i < kPacketSize; ++i) {
                const PiecewiseConstant2D::PointSample one = distribution.Sample(Lane(u, i));
                EXPECT_EQ(wide.column[i], uint32_t(one.step.x));
                EXPECT_EQ(wide.row[i], uint32_t(one.step.y));
                EXPECT_EQ(wide.pdf[i], one.pdf);
                ExpectNear(Lane(wide.p, i), one.p);
                EXPECT_EQ(pdf[i], distribution.PDF(Lane(u, i)));
            }
        });
    }
}

}  // namespace
}  // namespace pbrt
