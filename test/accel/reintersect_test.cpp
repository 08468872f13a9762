// A ray that leaves a surface point through OffsetOrigin never meets that primitive again.

#include "accel/trace.h"
#include "pbrt/shapes/place_mesh.h"

namespace pbrt {
namespace {

/// Directions from 1e-6 above the tangent plane (a unit vector's rounding is 1e-7) to straight up,
/// on both sides.
Vector3f LeavingDirection(Rng &rng, const SurfaceInteraction &s) {
    const Frame frame = Frame::FromZ(s.n);
    Vector3f w = RandomDirection(rng);
    if (rng.Below(2) == 0) w.z *= RandomScale(rng, -6, 0);
    w.z = std::copysign(std::max(std::abs(w.z), 1e-6f), w.z);
    return Normalize(frame.FromLocal(w));
}

/// Draws points on each primitive, finds them by rays from all around, leaves them, and counts how
/// many of those rays meet the primitive again. Convex shapes are left on their outside only, for
/// inside they may be met again.
struct Count {
    int tested = 0, met = 0;
};
Count MetAgain(const Traced &scene, int points, bool bothSides, Rng &rng) {
    Count count;
    for (uint32_t g = 0; g < scene.geometries.size(); ++g) {
        const Shape &shape = scene.geometries[g].shape;
        for (uint32_t k = 0; k < NPrimitives(shape); ++k)
            for (int i = 0; i < points; ++i) {
                const auto on = SampleArea(shape, k, rng.Uniform2D());
                if (!on) continue;
                const Point3f from = on->p + RandomScale(rng, -2, 2) * RandomDirection(rng);
                const Ray ray{from, on->p - from};
                for (const Hit &hit : scene.HitsWith(ray, g, k)) {
                    const SurfaceInteraction s = scene.At(hit, ray);
                    for (int j = 0; j < 10; ++j) {
                        Vector3f w = LeavingDirection(rng, s);
                        if (!bothSides) w = FaceForward(w, s.n);
                        count.met += int(scene.HitsWith({s.OffsetOrigin(w), w}, g, k).size());
                        ++count.tested;
                    }
                }
            }
    }
    return count;
}

TriangleMesh RandomTriangles(Rng &rng, int n) {
    TriangleMesh mesh;
    for (int i = 0; i < n; ++i) {
        const Point3f center = RandomScale(rng, -4, 3) * RandomPoint(rng, 1);
        const float size = RandomScale(rng, -3, 3);
        const Point3f a = center + size * RandomPoint(rng, 1),
                      b = center + size * RandomPoint(rng, 1);
        // A third corner close to an edge makes a sliver.
        const float sliver = rng.Below(3) == 0 ? RandomScale(rng, -4, 0) : 1;
        Point3f corners[] = {a, b, 0.5f * (a + b) + sliver * size * RandomPoint(rng, 1)};
        // Some lie in a plane across an axis, even through the origin.
        const int axis = int(rng.Below(3));
        const float height = rng.Below(2) == 0 ? 0 : center[axis];
        const bool flat = rng.Below(3) == 0;
        for (Point3f &p : corners) {
            if (flat) p[axis] = height;
            mesh.indices.push_back(uint32_t(mesh.p.size()));
            mesh.p.push_back(p);
        }
    }
    return mesh;
}

TEST(Reintersect, Triangles) {
    Rng rng(1);
    const Traced scene({Traced::Of(RandomTriangles(rng, 300))});
    const Count count = MetAgain(scene, 100, true, rng);
    EXPECT_GT(count.tested, 200000);
    EXPECT_EQ(count.met, 0);
}

/// Rotations, translations and scales, uneven where asked for.
Transform RandomTransform(Rng &rng, bool even) {
    const float size = RandomScale(rng, -3, 3);
    const auto factor = [&] { return size * (even ? 1 : RandomScale(rng, -1, 1)); };
    const float x = factor(), y = factor(), z = factor();
    return Transform::Translate(RandomScale(rng, -4, 4) * RandomPoint(rng, 1)) *
           *Transform::Rotate(360 * rng.Uniform(), RandomDirection(rng)) *
           *Transform::Scale({x, y, z});
}

template <typename MakeShape>
void ExpectNeverMetAgain(bool bothSides, MakeShape makeShape) {
    Rng rng(2);
    std::vector<Geometry> geometries;
    for (int i = 0; i < 100; ++i)
        geometries.push_back(Traced::Of(makeShape(RandomTransform(rng, i % 2 == 0), rng)));
    const Traced scene(std::move(geometries));
    const Count count = MetAgain(scene, 100, bothSides, rng);
    EXPECT_GT(count.tested, 50000);
    EXPECT_EQ(count.met, 0);
}

TEST(Reintersect, WholeSpheres) {
    ExpectNeverMetAgain(false, [](const Transform &t, Rng &) { return Sphere{t}; });
}
TEST(Reintersect, PartialSpheres) {
    ExpectNeverMetAgain(false, [](const Transform &t, Rng &rng) {
        const float zMin = -rng.Uniform();
        return Sphere{t, 1, zMin, zMin + 0.1f + 0.9f * rng.Uniform(), 0.5f + 5 * rng.Uniform()};
    });
}
TEST(Reintersect, Cylinders) {
    ExpectNeverMetAgain(false, [](const Transform &t, Rng &rng) {
        return Cylinder{t, 1, -rng.Uniform(), 0.1f + rng.Uniform(), 0.5f + 5.7f * rng.Uniform()};
    });
}
TEST(Reintersect, Disks) {
    ExpectNeverMetAgain(true, [](const Transform &t, Rng &rng) {
        return Disk{t, rng.Uniform(), 1, 0.9f * rng.Uniform(), 0.5f + 5.7f * rng.Uniform()};
    });
}

BilinearMesh OnePatch(const Point3f corners[4], const Transform &t) {
    BilinearMesh mesh;
    mesh.indices = {0, 1, 2, 3};
    mesh.p.assign(corners, corners + 4);
    EXPECT_FALSE(PlaceMesh(t, false, &mesh));
    return mesh;
}

TEST(Reintersect, FlatPatches) {
    ExpectNeverMetAgain(true, [](const Transform &t, Rng &rng) {
        const Point3f corners[4] = {{0, 0, 0},
                                    {1, 0.3f * rng.Uniform(), 0},
                                    {0.3f * rng.Uniform(), 1, 0},
                                    {0.8f + rng.Uniform(), 0.8f + rng.Uniform(), 0}};
        return OnePatch(corners, t);
    });
}

TEST(Reintersect, BentPatchesAboveTheirCurvature) {
    Rng rng(3);
    std::vector<Geometry> geometries;
    for (int i = 0; i < 200; ++i) {
        const Point3f corners[4] = {
            {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.05f + 0.1f * rng.Uniform()}};
        geometries.push_back(Traced::Of(OnePatch(corners, RandomTransform(rng, true))));
        ASSERT_FALSE(std::get<BilinearMesh>(geometries.back().shape).planar);
    }
    const Traced scene(std::move(geometries));
    int tested = 0;
    for (uint32_t g = 0; g < scene.geometries.size(); ++g)
        for (int i = 0; i < 100; ++i) {
            const auto on = SampleArea(scene.geometries[g].shape, 0, rng.Uniform2D());
            ASSERT_TRUE(on);
            const Point3f from = on->p + RandomScale(rng, -2, 2) * RandomDirection(rng);
            const Ray ray{from, on->p - from};
            for (const Hit &hit : scene.HitsWith(ray, g, 0)) {
                const SurfaceInteraction s = scene.At(hit, ray);
                const Frame frame = Frame::FromZ(s.n);
                // The patch stays within 12 degrees of each tangent plane.
                Vector3f w = RandomDirection(rng);
                if (std::abs(w.z) < 0.2f) continue;
                w = frame.FromLocal(w);
                EXPECT_TRUE(scene.HitsWith({s.OffsetOrigin(w), w}, g, 0).empty());
                ++tested;
            }
        }
    EXPECT_GT(tested, 10000);
}

}  // namespace
}  // namespace pbrt
