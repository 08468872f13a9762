#include <gtest/gtest.h>

#include "pbrt/accel/accel.h"

namespace pbrt {
namespace {

TEST(Accel, FindsTheNearestOfTriangleAndSphere) {
    std::vector<Geometry> geometries(2);
    TriangleMesh mesh;
    mesh.p = {{-10, -10, 5}, {10, -10, 5}, {0, 10, 5}};
    mesh.indices = {0, 1, 2};
    geometries[0].shape = mesh;
    geometries[1].shape = Sphere{Transform::Translate({0, 0, 2}), 1, -1, 1, 2 * Pi, false};
    const Accel accel(geometries, 2, {}, {}, 1);
    ASSERT_EQ(accel.Error(), "");
    Hit hit;
    const Ray ray{{0, 0, -3}, {0, 0, 1}};
    ASSERT_TRUE(accel.Intersect(ray, &hit));
    EXPECT_EQ(hit.geometry, 1u);
    EXPECT_EQ(hit.instance, ~0u);
    EXPECT_FLOAT_EQ(hit.t, 4);
    const SurfacePoint s = Interact(geometries[1].shape, hit, ray);
    EXPECT_EQ(s.n, (Normal3f{0, 0, -1}));
    EXPECT_FLOAT_EQ(s.p.z, 1);
    const Ray beside{{1.5f, 0, -3}, {0, 0, 1}};
    ASSERT_TRUE(accel.Intersect(beside, &hit));
    EXPECT_EQ(hit.geometry, 0u);
    EXPECT_EQ(Interact(geometries[0].shape, hit, beside).n, (Normal3f{0, 0, 1}));
    EXPECT_FALSE(accel.Intersect({{1.5f, 0, -3}, {0, 0, 1}, 7.9f}, &hit));
    EXPECT_TRUE(accel.Occluded(ray));
    EXPECT_FALSE(accel.Occluded({{50, 0, -3}, {0, 0, 1}}));
}

}  // namespace
}  // namespace pbrt
