#include "accel/trace.h"

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
    const SurfaceInteraction s = SurfaceAt(geometries[1].shape, hit, ray);
    EXPECT_EQ(s.n, (Normal3f{0, 0, -1}));
    EXPECT_FLOAT_EQ(s.p.z, 1);
    const Ray beside{{1.5f, 0, -3}, {0, 0, 1}};
    ASSERT_TRUE(accel.Intersect(beside, &hit));
    EXPECT_EQ(hit.geometry, 0u);
    EXPECT_EQ(SurfaceAt(geometries[0].shape, hit, beside).n, (Normal3f{0, 0, 1}));
    EXPECT_FALSE(accel.Intersect({{1.5f, 0, -3}, {0, 0, 1}, 7.9f}, &hit));
    EXPECT_TRUE(accel.Occluded(ray));
    EXPECT_FALSE(accel.Occluded({{50, 0, -3}, {0, 0, 1}}));
}

TEST(Accel, KnowsItsBoundsAndMemory) {
    const Accel empty({}, 0, {}, {}, 1);
    EXPECT_EQ(empty.Error(), "");
    Hit hit;
    EXPECT_FALSE(empty.Intersect({{0, 0, 0}, {0, 0, 1}}, &hit));
    EXPECT_FALSE(empty.Occluded({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_TRUE(empty.WorldBounds().Empty());

    std::vector<Geometry> geometries(2);
    geometries[0].shape = Sphere{Transform::Translate({1, 2, 3})};
    geometries[1].shape = Disk{Transform::Translate({0, 0, -4})};
    const Accel accel(geometries, 2, {}, {}, 1);
    const Bounds3f b = accel.WorldBounds();
    const Point3f min{-1, -1, -4}, max{2, 3, 4};
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(b.min[k], min[k], 1e-5f);
        EXPECT_NEAR(b.max[k], max[k], 1e-5f);
    }
    EXPECT_GT(accel.MemoryBytes(), 0u);
    EXPECT_LT(accel.MemoryBytes(), 1u << 22);
}

TEST(Accel, EveryHitNamesItsGeometryAndPrimitive) {
    // Shapes of all kinds in a row along x, some of them invisible.
    std::vector<Geometry> geometries;
    for (int i = 0; i < 60; ++i) {
        const float x = 3.f * float(i);
        const Transform t = Transform::Translate({x, 0, 0});
        TriangleMesh triangles;
        BilinearMesh patches;
        for (const float y : {-1.f, 1.f})
            for (const float side : {-1.f, 1.f}) {
                triangles.p.push_back({x + side, y, 0});
                patches.p.push_back({x + side, y, i % 2 == 0 ? 0 : 0.2f * side * y});
            }
        patches.planar = i % 2 == 0;
        triangles.indices = {0, 1, 2, 1, 3, 2};
        patches.indices = {0, 1, 2, 3};
        const Shape shapes[] = {triangles, patches, Sphere{t}, Disk{t}, Cylinder{t}};
        geometries.push_back(Traced::Of(shapes[i % 5]));
        if (i % 7 == 6) geometries.back().alpha = 0.f;
    }
    const Accel accel(geometries, uint32_t(geometries.size()), {}, {}, 2);
    for (uint32_t i = 0; i < geometries.size(); ++i) {
        const Ray ray{{3.f * float(i) + 0.5f, 0.3f, 9}, {0, 0, -1}};
        Hit hit;
        const bool seen = accel.Intersect(ray, &hit);
        EXPECT_EQ(seen, i % 7 != 6 && i % 5 != 4) << i;  // cylinders are open at their ends
        if (!seen) continue;
        EXPECT_EQ(hit.geometry, i);
        EXPECT_EQ(hit.primitive, i % 5 == 0 ? 1u : 0u);
        const SurfaceInteraction s = SurfaceAt(geometries[i].shape, hit, ray);
        // The point is put together from the corners or from the object's frame: eight roundings of
        // half an ulp of the largest number that takes part, the far corner, as a bound.
        const auto bound = [](float largest) {
            return 4 * (std::nextafter(largest, 1e9f) - largest);
        };
        EXPECT_NEAR(s.p.x, ray.o.x, bound(3.f * float(i) + 1));
        EXPECT_NEAR(s.p.y, ray.o.y, bound(1));
    }
}

TEST(Accel, DegenerateTrianglesAreNeverMet) {
    TriangleMesh mesh;
    mesh.p = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 1, 1}};
    mesh.indices = {0, 1, 2, 3, 3, 3, 0, 4, 0, 1, 3, 1};
    std::vector<Geometry> geometries{Traced::Of(mesh)};
    const Accel accel(geometries, 1, {}, {}, 1);
    Rng rng(1);
    for (int i = 0; i < 100000; ++i) {
        const Point3f o = 3.f * RandomPoint(rng, 1);
        const uint32_t k = 3 * rng.Below(4);
        const Point3f p = Lerp(rng.Uniform(), mesh.p[mesh.indices[k]], mesh.p[mesh.indices[k + 1]]);
        EXPECT_FALSE(accel.Occluded({o, p - o}));
    }
}

TEST(Accel, MovesWithItsOwner) {
    std::vector<Geometry> geometries{Traced::Of(Sphere{})};
    Accel first(geometries, 1, {}, {}, 1);
    Accel second = std::move(first);
    EXPECT_TRUE(second.Occluded({{0, 0, -3}, {0, 0, 1}}));
}

}  // namespace
}  // namespace pbrt
