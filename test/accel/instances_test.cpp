// An instance looks like a copy made where it stands.

#include "accel/trace.h"
#include "pbrt/shapes/instanced.h"
#include "pbrt/shapes/place_mesh.h"

namespace pbrt {
namespace {

TriangleMesh Blob(Rng &rng) {
    TriangleMesh mesh;
    for (int i = 0; i < 60; ++i) {
        mesh.p.push_back(RandomPoint(rng, 1));
        mesh.n.push_back(RandomDirection(rng));
        mesh.s.push_back(RandomDirection(rng));
        mesh.uv.push_back(rng.Uniform2D());
    }
    for (int i = 0; i < 120; ++i)
        mesh.indices.push_back(rng.Below(60));
    return mesh;
}

/// Geometry 0: a triangle mesh, 1: a sphere, 2: a bent patch, 3: flat patches, 4: a cylinder.
std::vector<Geometry> Models(const Transform &t) {
    Rng rng(7);
    std::vector<Geometry> list;
    TriangleMesh blob = Blob(rng);
    EXPECT_FALSE(PlaceMesh(t, false, &blob));
    list.push_back(Traced::Of(blob));
    list.push_back(Traced::Of(Sphere{t * Transform::Translate({0, 2, 0}), 0.8f, -0.8f, 0.8f}));
    BilinearMesh bent, flat;
    bent.p = {{2, 0, 0}, {3, 0, 0.4f}, {2, 1, 0}, {3, 1, 0}};
    flat.p = {{2, -2, 0}, {3, -2, 0}, {2, -1, 0}, {3.5f, -0.7f, 0}};
    for (BilinearMesh *m : {&bent, &flat}) {
        m->indices = {0, 1, 2, 3};
        EXPECT_FALSE(PlaceMesh(t, false, m));
        list.push_back(Traced::Of(*m));
    }
    EXPECT_FALSE(bent.planar);
    EXPECT_TRUE(flat.planar);
    list.push_back(
        Traced::Of(Cylinder{t * Transform::Translate({-2, 0, 0}), 0.5f, -1, 1, 2 * Pi, true}));
    return list;
}

Instance MovingInstance(const Transform &from, const Transform &to) {
    return {0, AffineTransform(from), std::make_unique<const std::vector<Transform>>(1, to)};
}

void ExpectNear(Vector3f a, Vector3f b, float tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Rays through instanced models find what rays through copies of them find.
void ExpectEqual(const std::vector<Transform> &places, float time, const Instance &like) {
    std::vector<Geometry> models = Models(Transform()), copies;
    const uint32_t count = uint32_t(models.size());
    std::vector<Instance> instances;
    for (const Transform &t : places) {
        for (Geometry &g : Models(t))
            copies.push_back(std::move(g));
        instances.push_back({1, like.Moves() ? like.renderFromObject : AffineTransform(t)});
        if (like.Moves())
            instances.back().later = std::make_unique<const std::vector<Transform>>(*like.later);
    }
    // A plane of its own at top level shifts nothing.
    const std::vector<ObjectRange> objects{{0, 0}, {1, 1 + count}};
    std::vector<Geometry> all(1);
    all[0].shape = Sphere{Transform::Translate({0, 0, 1000})};
    for (Geometry &g : models)
        all.push_back(std::move(g));
    const Accel instanced(all, 1, objects, instances, 2);
    const Accel direct(copies, uint32_t(copies.size()), {}, {}, 2);
    ASSERT_EQ(instanced.Error(), "");

    Rng rng(11);
    int hits = 0, differ = 0;
    for (int i = 0; i < 20000; ++i) {
        const Point3f o = RandomPoint(rng, 20);
        const Ray ray{o, RandomPoint(rng, 6) - o, Infinity, time};
        Hit a, b;
        const bool hitA = instanced.Intersect(ray, &a), hitB = direct.Intersect(ray, &b);
        EXPECT_EQ(instanced.Occluded(ray), hitA);
        // Rounding may decide at edges.
        if (hitA != hitB || (hitA && (a.geometry - 1 + count * a.instance != b.geometry ||
                                      a.primitive != b.primitive))) {
            ++differ;
            continue;
        }
        if (!hitA) continue;
        ++hits;
        const Transform &t = places[a.instance];
        const Ray local{t.Inverse().Point(ray.o), t.Inverse().Vector(ray.d)};
        const SurfaceInteraction s = FromInstance(t, SurfaceAt(all[a.geometry].shape, a, local));
        const SurfaceInteraction c = SurfaceAt(copies[b.geometry].shape, b, ray);
        ExpectNear(s.p, c.p, 2e-4f);
        EXPECT_GT(Dot(s.n, c.n), 0.9999f);
        EXPECT_GT(Dot(s.ns, c.ns), 0.999f);
        EXPECT_NEAR(s.uv.x, c.uv.x, 2e-3f);
        EXPECT_NEAR(s.uv.y, c.uv.y, 2e-3f);
        EXPECT_EQ(s.faceIndex, c.faceIndex);
    }
    EXPECT_GT(hits, 900);
    EXPECT_LE(differ, 5);
}

TEST(Instances, LookLikeCopies) {
    const std::vector<Transform> places{
        Transform::Translate({5, 1, -2}) * *Transform::Rotate(30, {1, 2, 3}),
        Transform::Translate({-5, 2, 2}) * *Transform::Scale({1.5f, 0.5f, 1}),
        Transform::Translate({0, -5, 2}) * *Transform::Scale({-1, 1, 1.2f})};
    ExpectEqual(places, 0, {});
}

TEST(Instances, MoveLinearlyBetweenTheirKeys) {
    const Instance moving =
        MovingInstance(Transform::Translate({-4, 0, 0}),
                       Transform::Translate({4, 2, 0}) * *Transform::Scale({2, 1, 1}));
    const Transform middle = Transform::Translate({-2, 0.5f, 0}) * *Transform::Scale({1.25f, 1, 1});
    ExpectEqual({middle}, 0.25f, moving);
}

/// Spawned rays do not meet nearby what they come from. The bent patch and the cylinder's inside
/// may be met again, but not at once.
void ExpectLeft(const Instance &instance, float time) {
    std::vector<Geometry> models = Models(Transform::Translate({5, 5, 5}));
    const std::vector<ObjectRange> objects{{0, uint32_t(models.size())}};
    const Accel accel(models, 0, objects, std::span(&instance, 1), 2);
    Matrix4 m;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            m[i][j] = Lerp(time, instance.Key(0).Matrix()[i][j],
                           instance.Key(instance.NKeys() - 1).Matrix()[i][j]);
    const Transform t = *Transform::FromMatrix(m);
    Rng rng(5);
    int tested = 0;
    for (int i = 0; i < 50000; ++i) {
        const Point3f target = t.Point(Point3f{5, 5, 5} + RandomPoint(rng, 3));
        const Point3f from = target + 10.f * RandomDirection(rng);
        const Ray ray{from, target - from, Infinity, time};
        Hit hit;
        if (!accel.Intersect(ray, &hit)) continue;
        const Ray local{t.Inverse().Point(ray.o), t.Inverse().Vector(ray.d)};
        const SurfaceInteraction s =
            FromInstance(t, SurfaceAt(models[hit.geometry].shape, hit, local));
        Vector3f w = FaceForward(RandomDirection(rng), s.n);
        const float cosTheta = Dot(w, s.n);
        if (cosTheta < 0.01f) continue;
        const Ray away{s.OffsetOrigin(w), w, 0.3f, time};
        Hit again;
        const bool isSame = accel.Intersect(away, &again) && again.geometry == hit.geometry &&
                            again.primitive == hit.primitive;
        EXPECT_TRUE(!isSame || again.t > 0.003f * cosTheta)
            << hit.geometry << " at " << again.t << " cosine " << cosTheta;
        ++tested;
    }
    EXPECT_GT(tested, 3000);
}

TEST(Instances, SpawnedRaysLeaveThem) {
    const Transform t = Transform::Translate({300, -200, 100}) * *Transform::Rotate(70, {1, 1, 0}) *
                        *Transform::Scale({0.3f, 2, 1});
    ExpectLeft({0, AffineTransform(t)}, 0);
}

TEST(Instances, SpawnedRaysLeaveThemInMotion) {
    Rng rng(6);
    for (int i = 0; i < 5; ++i) {
        const Transform t0 = Transform::Translate(300.f * RandomDirection(rng)) *
                             *Transform::Rotate(70, RandomDirection(rng)) *
                             *Transform::Scale({0.3f, 2, 1});
        const Transform t1 =
            Transform::Translate({1, 2, 3}) * t0 * *Transform::Rotate(20, RandomDirection(rng));
        ExpectLeft(MovingInstance(t0, t1), rng.Uniform());
    }
}

TEST(Instances, OfEmptyOrInvisibleObjectsAreNothing) {
    std::vector<Geometry> models(1);
    models[0].shape = Sphere{};
    models[0].alpha = 0.f;
    const std::vector<ObjectRange> objects{{0, 1}, {1, 1}};
    std::vector<Instance> instances;
    instances.push_back({0, {}});
    instances.push_back({1, {}});
    const Accel accel(models, 0, objects, instances, 1);
    EXPECT_EQ(accel.Error(), "");
    EXPECT_FALSE(accel.Occluded({{0, 0, -3}, {0, 0, 1}}));
}

}  // namespace
}  // namespace pbrt
