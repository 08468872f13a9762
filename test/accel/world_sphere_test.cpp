// Whole spheres that need no turning are met in rendering space: where all others are met.

#include "pbrt/accel/world_sphere.h"
#include "accel/trace.h"
#include "pbrt/accel/object_from_render.h"

namespace pbrt {
namespace {

/// Moved, scaled evenly, mirrored and turned by quarters.
Transform BallTransform(Rng &rng) {
    const float size = RandomScale(rng, -3, 3);
    const auto sign = [&] { return rng.Below(2) == 0 ? size : -size; };
    const float x = sign(), y = sign(), z = sign();
    const Matrix4 quarter{{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};
    const Transform turn = rng.Below(2) == 0 ? Transform() : *Transform::FromMatrix(quarter);
    return Transform::Translate(RandomScale(rng, -4, 4) * RandomPoint(rng, 1)) * turn *
           *Transform::Scale({x, y, z});
}

/// From far off, from inside and from next to the surface; to the middle and past the rim.
Ray RayAt(Rng &rng, Point3f center, float radius) {
    const Point3f on = center + radius * RandomDirection(rng);
    const float away = rng.Below(2) == 0 ? RandomScale(rng, -7, 3) : -RandomScale(rng, -7, 0);
    const Point3f o = center + (1 + away) * (on - center);
    const Point3f aim = center + radius * (0.5f + rng.Uniform()) * RandomDirection(rng);
    const float tMax = rng.Below(3) == 0 ? 2 * rng.Uniform() : Infinity;
    return {o, rng.Below(2) == 0 ? aim - o : RandomDirection(rng), tMax};
}

TEST(Balls, AreWhatTheirTransformLeavesRound) {
    Rng rng(1);
    const auto isBall = [](const Transform &t, Sphere s = {}) {
        s.renderFromObject = t;
        return WorldSphere::Of(s).has_value();
    };
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(isBall(BallTransform(rng)));
    EXPECT_FALSE(isBall(*Transform::Scale({1, 1, 1.0001f})));
    EXPECT_FALSE(isBall(*Transform::Scale({2, 1, 1})));
    EXPECT_FALSE(isBall(*Transform::Rotate(45, {0, 0, 1})));
    EXPECT_TRUE(isBall(*Transform::Rotate(90, {0, 0, 1})));
    // Skewed by less than half an ulp of the scale: far along the ground that is more than the
    // offset of a spawned ray.
    EXPECT_FALSE(isBall(
        *Transform::FromMatrix({{{1, 5e-9f, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}})));
    Sphere partial;
    partial.zMax = 0.5f;
    EXPECT_FALSE(isBall(Transform(), partial));
    EXPECT_FALSE(WorldSphere::Of(Disk{}).has_value());
}

TEST(Balls, AreMetWhereSpheresAreMet) {
    Rng rng(2);
    int hits = 0, differ = 0;
    for (int k = 0; k < 200; ++k) {
        const Transform t = BallTransform(rng);
        const float radius = RandomScale(rng, -1, 1);
        const Sphere sphere{t, radius, -radius, radius};
        std::vector<Geometry> geometries(1);
        geometries[0].shape = sphere;
        const Accel accel(geometries, 1, {}, {}, 1);
        const std::optional<WorldSphere> ball = WorldSphere::Of(sphere);
        ASSERT_TRUE(ball);
        const ObjectFromRender toObject(t);
        for (int j = 0; j < 40; ++j) {
            RayPacket rays;
            for (int i = 0; i < kPacketSize; ++i)
                rays.Set(i, RayAt(rng, ball->center, float(ball->radius)));
            HitPacket met;
            const LaneBits lanes = accel.Intersect(rays, kAllLanes, &met, Coherence::Alike);
            EXPECT_EQ(accel.Occluded(rays, kAllLanes), lanes);
            for (int i = 0; i < kPacketSize; ++i) {
                const Ray ray = rays.At(i);
                Hit single;
                const bool hit = accel.Intersect(ray, &single);
                const auto expected =
                    sphere.Intersect(0, RayD{toObject.Point(ToDouble(ray.o)),
                                             toObject.Vector(ToDouble(ray.d)), 0, ray.tMax});
                EXPECT_EQ(hit, lanes >> i & 1);
                EXPECT_EQ(accel.Occluded(ray), hit);
                if (hit != expected.has_value()) {
                    ++differ;
                    continue;
                }
                if (!hit) continue;
                ++hits;
                // The same operations in double, of which some may be contracted to one rounding.
                EXPECT_FLOAT_EQ(single.t, met.t[i]);
                EXPECT_EQ(met.geometry[i], 0u);
                EXPECT_EQ(met.instance[i], ~0u);
                // Rounded to float once; before that the ways differ by roundings of the transform
                // in double, and by more where the ray grazes.
                const Vector3d d = ToDouble(ray.d), c = ToDouble(ball->center);
                const Vector3d n = ToDouble(ray.o) - c + expected->t * d;
                const double perStep = std::abs(Dot(n, d)) / Length(n);
                const double size = Length(c) + ball->radius + Length(ToDouble(ray.o) - c);
                EXPECT_NEAR(single.t, expected->t, 6e-8 * expected->t + 1e-15 * size / perStep);
            }
        }
    }
    EXPECT_GT(hits, 40000);
    EXPECT_EQ(differ, 0);
}

/// Where the way to the closest approach is 0, of either sign.
TEST(Balls, AreMetFromTheirCenterAndAcrossTheirRadius) {
    const Point3f center{3, -2, 0.5f};
    std::vector<Geometry> geometries(1);
    geometries[0].shape = Sphere{Transform::Translate(center), 2, -2, 2};
    const Accel accel(geometries, 1, {}, {}, 1);
    const Vector3f axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < 6; ++k) {
        const Vector3f d = k < 3 ? axes[k] : -axes[k - 3];
        RayPacket rays;
        for (int i = 0; i < kPacketSize; ++i)
            rays.Set(i, {center + (0.5f * (i % 4)) * axes[(k + 1) % 3], d});
        HitPacket met;
        EXPECT_EQ(accel.Intersect(rays, kAllLanes, &met, Coherence::Alike), kAllLanes);
        for (int i = 0; i < kPacketSize; ++i) {
            Hit single;
            const bool hit = accel.Intersect(rays.At(i), &single);
            const float expected = std::sqrt(4 - Sqr(0.5f * (i % 4)));
            EXPECT_TRUE(hit);
            EXPECT_FLOAT_EQ(single.t, expected);
            EXPECT_FLOAT_EQ(met.t[i], expected);
        }
    }
}

}  // namespace
}  // namespace pbrt
