#include "pbrt/util/motion.h"

#include <gtest/gtest.h>

#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"

namespace pbrt {
namespace {

void ExpectNear(const Transform &a, const Transform &b, float tolerance) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 4; ++j)
            EXPECT_NEAR(a.Matrix()[i][j], b.Matrix()[i][j], tolerance) << i << " " << j;
}

Transform Stretch(float x, float y, float z) {
    return *Transform::Scale({x, y, z});
}

TEST(Motion, IsExactAtItsEnds) {
    Rng rng(1);
    for (int i = 0; i < 200; ++i) {
        const auto random = [&] {
            const Vector3f axis = SampleUniformSphere(rng.Uniform2D());
            const float angle = 360 * rng.Uniform(), x = rng.Uniform(), y = rng.Uniform();
            return Transform::Translate({5 * x, -3 * y, 1}) * *Transform::Rotate(angle, axis) *
                   Stretch(0.2f + x, 2 * y + 0.1f, -1.5f);
        };
        const Transform a = random(), b = random();
        ExpectNear(*InterpolateMotion(a, b, 0), a, 1e-5f);
        ExpectNear(*InterpolateMotion(a, b, 1), b, 1e-5f);
    }
}

TEST(Motion, TurnsEvenly) {
    Rng rng(2);
    for (const float degrees : {0.01f, 30.f, 90.f, 150.f, 179.9f}) {
        const Vector3f axis = SampleUniformSphere(rng.Uniform2D());
        const Transform start = *Transform::Rotate(70, {1, 2, 3}) * Stretch(1, 2, 0.5f);
        const Transform end = Transform::Translate({4, 0, -2}) * *Transform::Rotate(degrees, axis) *
                              *Transform::Rotate(70, {1, 2, 3}) * Stretch(3, 2, 0.5f);
        const float t = rng.Uniform();
        const Transform expected =
            Transform::Translate({4 * t, 0, -2 * t}) * *Transform::Rotate(t * degrees, axis) *
            *Transform::Rotate(70, {1, 2, 3}) * Stretch(Lerp(t, 1.f, 3.f), 2, 0.5f);
        ExpectNear(*InterpolateMotion(start, end, t), expected, 2e-5f);
    }
}

TEST(Motion, KeysKeepNearTheArc) {
    const Transform a = Stretch(2, 2, 2), b = *Transform::Rotate(170, {1, 1, 0}) * a;
    std::vector<Transform> keys = KeysBetween(a, b);
    ASSERT_GT(keys.size(), 10u);
    ASSERT_LE(keys.size(), 127u);  // Embree takes 129 in all
    keys.insert(keys.begin(), a);
    keys.push_back(b);
    for (size_t i = 0; i + 1 < keys.size(); ++i) {
        const Transform between =
            *InterpolateMotion(a, b, (float(i) + 0.5f) / float(keys.size() - 1));
        for (const Vector3f v : {Vector3f{1, 0, 0}, Vector3f{0, 1, 0}, Vector3f{0, 0, 1}}) {
            const Vector3f chord = 0.5f * (keys[i].Vector(v) + keys[i + 1].Vector(v));
            EXPECT_LE(Length(chord - between.Vector(v)), 1e-3f * 2);
        }
    }
}

TEST(Motion, WhatDoesNotTurnNeedsNoKeys) {
    const Transform t = *Transform::Rotate(40, {1, 2, 3}) * Stretch(1, -2, 3);
    EXPECT_TRUE(KeysBetween(t, Transform::Translate({1, 2, 3}) * t).empty());
    EXPECT_TRUE(KeysBetween(t, t * Stretch(2, 2, 2)).empty());
    // Through a plane there is no way to turn.
    EXPECT_FALSE(InterpolateMotion(t, Stretch(1, 1, 1), 0.5f));
    EXPECT_TRUE(KeysBetween(t, Stretch(1, 1, 1)).empty());
}

}  // namespace
}  // namespace pbrt
