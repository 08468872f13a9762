#include "pbrt/lights/light_bounds.h"

#include "lights/light_scene.h"

namespace pbrt::test {
namespace {

bool Holds(const DirectionCone &c, Vector3f w, float slack) {
    return AngleBetween(c.axis, w) <= std::acos(c.cosTheta) + slack;
}

Vector3f RandomInCone(const DirectionCone &c, std::mt19937 &rng) {
    std::uniform_real_distribution<float> u(0, 1);
    const float z = Lerp(u(rng), 1.f, c.cosTheta), phi = 2 * Pi * u(rng), r = SafeSqrt(1 - z * z);
    return Frame::FromZ(c.axis).FromLocal({r * std::cos(phi), r * std::sin(phi), z});
}

TEST(DirectionCones, UnionHoldsBoth) {
    std::mt19937 rng(1);
    std::uniform_real_distribution<float> cosine(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const DirectionCone a{UniformDirection(rng), cosine(rng)};
        const DirectionCone b{UniformDirection(rng), i % 3 == 0 ? 1.f : cosine(rng)};
        const DirectionCone u = Union(a, b);
        for (int k = 0; k < 20; ++k) {
            EXPECT_TRUE(Holds(u, RandomInCone(a, rng), 2e-3f));
            EXPECT_TRUE(Holds(u, RandomInCone(b, rng), 2e-3f));
        }
    }
}

TEST(DirectionCones, UnionIsTight) {
    const auto cone = [](float degrees, float half) {
        return DirectionCone{{std::sin(Radians(degrees)), 0, std::cos(Radians(degrees))},
                             std::cos(Radians(half))};
    };
    const DirectionCone u = Union(cone(0, 10), cone(50, 20));
    EXPECT_NEAR(std::acos(u.cosTheta), Radians(40), Radians(1e-3f));
    EXPECT_NEAR(AngleBetween(u.axis, cone(30, 0).axis), 0, Radians(1e-3f));
    EXPECT_EQ(Union(cone(0, 30), cone(10, 5)).cosTheta, cone(0, 30).cosTheta);
    EXPECT_EQ(Union(cone(0, 100), cone(180, 90)).cosTheta, -1);
}

TEST(DirectionCones, ManyEqualConesDoNotGrow) {
    const DirectionCone one{Normalize(Vector3f{0.3f, -0.5f, 0.7f}), 1};
    DirectionCone all = one;
    for (int i = 0; i < 100000; ++i)
        all = Union(all, one);
    EXPECT_GT(all.cosTheta, 1 - 1e-6f);
}

LightBounds Patch(Point3f p, Vector3f n, float power = 1) {
    return {{p, p}, {n, 1}, 0, power, false};
}

TEST(LightBounds, AreImportantWhereTheyShine) {
    const LightBounds b = Patch({0, 0, 1}, {0, 0, -1});
    EXPECT_GT(Importance(b, {0, 0, 0}, {0, 0, 1}), 0);
    EXPECT_EQ(Importance(b, {0, 0, 2}, {0, 0, 1}), 0);
    EXPECT_EQ(Importance(b, {3, 0, 1.5f}, {}), 0);
    LightBounds both = b;
    both.twoSided = true;
    EXPECT_GT(Importance(both, {0, 0, 2}, {0, 0, -1}), 0);
    // From behind the receiver.
    EXPECT_EQ(Importance(both, {0, 0, 2}, {0, 0, 1}), 0);
    EXPECT_GT(Importance(both, {0, 0, 2}, {}), 0);
}

TEST(LightBounds, GrazingLightCountsLess) {
    const LightBounds b = Patch({0, 0, 1}, {0, 0, -1});
    const Point3f below{0, 0, 0}, aside{std::sin(1.4f), 0, 1 - std::cos(1.4f)};
    EXPECT_LT(Importance(b, aside, {}), 0.2f * Importance(b, below, {}));
    // And at the receiver.
    EXPECT_LT(Importance(b, below, Normalize(Vector3f{1, 0, 0.1f})),
              0.2f * Importance(b, below, {0, 0, 1}));
}

TEST(LightBounds, FallOffByInverseSquareAndGrowWithPower) {
    const LightBounds b = Patch({0, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(Importance(b, {0, 0, 2}, {}) / Importance(b, {0, 0, 6}, {}), 9, 1e-4);
    EXPECT_NEAR(
        Importance(Patch({0, 0, 0}, {0, 0, 1}, 5), {0, 0, 2}, {}) / Importance(b, {0, 0, 2}, {}), 5,
        1e-4);
}

/// The sum's importance is no less than what arrives from any part: power cos cos / d^2.
TEST(LightBounds, BoundWhatTheirPartsSend) {
    std::mt19937 rng(8);
    std::uniform_real_distribution<float> place(-1, 1);
    for (int i = 0; i < 300; ++i) {
        LightBounds all;
        std::vector<LightBounds> parts;
        const Vector3f up = UniformDirection(rng);
        for (int k = 0; k < 6; ++k) {
            parts.push_back(
                Patch({place(rng), place(rng), place(rng)}, RandomInCone({up, 0.9f}, rng)));
            all = Union(all, parts.back());
        }
        for (int k = 0; k < 50; ++k) {
            const Point3f p = 3.f * Vector3f{place(rng), place(rng), place(rng)};
            const Normal3f n = UniformDirection(rng);
            for (const LightBounds &part : parts) {
                const Vector3f d = part.bounds.min - p;
                const float cosines = std::max(0.f, -Dot(part.normals.axis, d)) *
                                      std::max(0.f, Dot(n, d)) / LengthSquared(d);
                const float radius = Length(all.bounds.Diagonal()) / 2;
                const float d2 = std::max(DistanceSquared(p, all.bounds.Center()), Sqr(radius));
                EXPECT_GE(Importance(all, p, n) * d2 * 1.001f, cosines);
            }
        }
    }
}

TEST(LightBounds, OfLightsHoldTheirPower) {
    const LightScene s(
        "LightSource \"point\" \"float power\" 5\n"
        "LightSource \"spot\" \"point3 to\" [ 0 1 0 ]\nLightSource \"distant\"\n"
        "LightSource \"infinite\"");
    ASSERT_EQ(s.lights.size(), 4u);
    EXPECT_NEAR(Bounds(s.lights[0])->power, 5, 1e-3);
    EXPECT_EQ(Bounds(s.lights[0])->normals.cosTheta, -1);
    EXPECT_NEAR(Bounds(s.lights[1])->normals.axis.y, 1, 1e-6);
    EXPECT_FALSE(Bounds(s.lights[2]));
    EXPECT_FALSE(Bounds(s.lights[3]));
}

}  // namespace
}  // namespace pbrt::test
