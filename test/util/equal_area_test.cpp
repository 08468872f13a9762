#include "pbrt/util/equal_area.h"

#include <gtest/gtest.h>

#include <random>

namespace pbrt {
namespace {

constexpr int kPoints = 100000;

TEST(EqualArea, SquareSphereSquareIsTheIdentity) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < kPoints; ++i) {
        const Point2f p{uniform(random), uniform(random)};
        const Vector3f d = EqualAreaSquareToSphere(p);
        EXPECT_NEAR(Length(d), 1, 1e-6f);
        const Point2f q = EqualAreaSphereToSquare(d);
        EXPECT_NEAR(q.x, p.x, 1e-6f);
        EXPECT_NEAR(q.y, p.y, 1e-6f);
    }
}

TEST(EqualArea, SphereSquareSphereIsTheIdentity) {
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    for (int i = 0; i < kPoints; ++i) {
        // A tenth of the directions hug the z axis, where 1 - |z| cancels.
        const float squeeze = i % 10 == 0 ? 1e-4f : 1.f;
        const Vector3f d =
            Normalize(Vector3f{squeeze * normal(random), squeeze * normal(random), normal(random)});
        EXPECT_LT(Length(EqualAreaSquareToSphere(EqualAreaSphereToSquare(d)) - d), 2e-6f);
    }
}

TEST(EqualArea, LayoutIsPbrts) {
    const auto expectAt = [](Point2f p, Vector3f d) {
        EXPECT_LT(Length(EqualAreaSquareToSphere(p) - d), 1e-6f) << p.x << ' ' << p.y;
        const Point2f q = EqualAreaSphereToSquare(d);
        EXPECT_LT(Length(EqualAreaSquareToSphere(q) - d), 1e-6f) << q.x << ' ' << q.y;
    };
    expectAt({0.5f, 0.5f}, {0, 0, 1});
    expectAt({1, 0.5f}, {1, 0, 0});
    expectAt({0, 0.5f}, {-1, 0, 0});
    expectAt({0.5f, 1}, {0, 1, 0});
    expectAt({0.5f, 0}, {0, -1, 0});
    for (const Point2f corner : {Point2f{0, 0}, Point2f{1, 0}, Point2f{0, 1}, Point2f{1, 1}})
        expectAt(corner, {0, 0, -1});
}

TEST(EqualArea, CellsOfEqualSizeHaveEqualSolidAngle) {
    // The Jacobian |dd/du x dd/dv| is 4 pi everywhere but on the fold lines, where differences
    // across the crease are meaningless: points within two steps of one are left out.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.01f, 0.99f);
    const float h = 1e-3f;
    int compared = 0;
    for (int i = 0; i < kPoints; ++i) {
        const Point2f p{uniform(random), uniform(random)};
        const float u = std::abs(2 * p.x - 1), v = std::abs(2 * p.y - 1);
        if (std::min({u, v, std::abs(1 - u - v), 1 - u, 1 - v}) < 8 * h) continue;
        const Vector3f du = EqualAreaSquareToSphere(Point2f{p.x + h, p.y}) -
                            EqualAreaSquareToSphere(Point2f{p.x - h, p.y});
        const Vector3f dv = EqualAreaSquareToSphere(Point2f{p.x, p.y + h}) -
                            EqualAreaSquareToSphere(Point2f{p.x, p.y - h});
        const float jacobian = Length(Cross(du, dv)) / Sqr(2 * h);
        // Second order in h / r, r >= 16 h: 1 %.
        EXPECT_NEAR(jacobian / (4 * Pi), 1, 0.01f) << p.x << ' ' << p.y;
        ++compared;
    }
    EXPECT_GT(compared, kPoints / 2);
}

/// Where a picture's neighbourhood goes on beyond the square's edges: each edge is glued to itself,
/// turned about its middle. p in [-1, 2]^2.
Point2f WrapEqualAreaSquare(Point2f p) {
    if (p.x < 0 || p.x > 1) p = {p.x < 0 ? -p.x : 2 - p.x, 1 - p.y};
    if (p.y < 0 || p.y > 1) p = {1 - p.x, p.y < 0 ? -p.y : 2 - p.y};
    return p;
}

TEST(EqualArea, DirectionsAreContinuousAcrossTheEdges) {
    const float h = 1e-4f;
    for (int i = 1; i < 20; ++i) {
        const float t = i / 20.f;
        for (const Point2f outside :
             {Point2f{-h, t}, Point2f{1 + h, t}, Point2f{t, -h}, Point2f{t, 1 + h}}) {
            const Point2f edge{std::clamp(outside.x, 0.f, 1.f), std::clamp(outside.y, 0.f, 1.f)};
            const Vector3f beyond = EqualAreaSquareToSphere(WrapEqualAreaSquare(outside));
            EXPECT_LT(Length(beyond - EqualAreaSquareToSphere(edge)), 30 * h);
        }
    }
}

}  // namespace
}  // namespace pbrt
