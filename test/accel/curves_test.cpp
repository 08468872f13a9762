#include "accel/trace.h"

namespace pbrt {
namespace {

CurveSet RandomCurves(Rng &rng, int segments, float radius) {
    CurveSet c;
    for (int k = 0; k < segments; ++k) {
        c.first.push_back(uint32_t(c.points.size()));
        const Point3f start = RandomPoint(rng, 1);
        for (int i = 0; i < 4; ++i) {
            const Vector3f bend = RandomPoint(rng, 0.1f);
            c.points.push_back(
                {start + (float(i) * 0.25f) * Vector3f{1, 0, 0} + bend, radius * (1 - 0.1f * i)});
        }
    }
    return c;
}

/// How far the ray passes from a segment's axis, in radii there, and where on the axis; the nearest
/// of many points, then refined.
struct Passing {
    float radii = Infinity, u = 0;
};
Passing PassOf(const CurvePoint *c, const Ray &ray) {
    Passing best;
    const auto look = [&](float u) {
        const CurveAt at(c, u);
        const Vector3f from = at.p - ray.o;
        const Vector3f beside = from - Dot(from, ray.d) * ray.d;
        const float radii = Length(beside) / at.radius;
        if (radii < best.radii) best = {radii, u};
    };
    for (int i = 0; i <= 400; ++i)
        look(float(i) / 400);
    const float about = best.u;
    for (int i = -20; i <= 20; ++i)
        look(std::clamp(about + float(i) / 8000, 0.f, 1.f));
    return best;
}

// A ray meets a flat curve where it passes within its radius, but for the quarter by which chords
// may leave its axis.
TEST(Curves, AreMetWithinTheirRadius) {
    Rng rng(3);
    const CurveSet set = RandomCurves(rng, 40, 0.02f);
    const Traced traced({Traced::Of(set)});
    int met = 0, wrong = 0, unclear = 0;
    for (int k = 0; k < 4000; ++k) {
        const uint32_t segment = rng.Below(40);
        const CurveAt at(&set.points[set.first[segment]], Lerp(rng.Uniform(), 0.05f, 0.95f));
        Ray ray;
        ray.d = RandomDirection(rng);
        if (std::abs(Dot(ray.d, Normalize(at.dpdu))) > 0.9f) continue;  // ends and loops in view
        ray.o = at.p + RandomPoint(rng, 2 * at.radius) - 3.f * ray.d;
        const Passing pass = PassOf(&set.points[set.first[segment]], ray);
        if (pass.u == 0 || pass.u == 1) continue;  // beyond an end, which is cut off flat
        const bool isMet = !traced.HitsWith(ray, 0, segment).empty();
        met += isMet;
        if (std::abs(pass.radii - 1) < 0.25f)
            ++unclear;
        else
            wrong += isMet != (pass.radii < 1);
    }
    EXPECT_GT(met, 1000);
    EXPECT_LT(unclear, 1000);
    EXPECT_EQ(wrong, 0);
}

TEST(Curves, ReportWhereTheyAreMet) {
    Rng rng(4);
    const CurveSet set = RandomCurves(rng, 40, 0.02f);
    const Traced traced({Traced::Of(set)});
    for (int k = 0; k < 2000; ++k) {
        const uint32_t segment = rng.Below(40);
        const CurveAt at(&set.points[set.first[segment]], Lerp(rng.Uniform(), 0.1f, 0.9f));
        Ray ray;
        ray.d = RandomDirection(rng);
        if (std::abs(Dot(ray.d, Normalize(at.dpdu))) > 0.8f) continue;
        const Vector3f side = Normalize(Cross(at.dpdu, ray.d));
        const float v = Lerp(rng.Uniform(), 0.1f, 0.9f);
        ray.o = at.p - (2 * v - 1) * at.radius * side - 3.f * ray.d;
        const auto hits = traced.HitsWith(ray, 0, segment);
        ASSERT_FALSE(hits.empty());
        const SurfaceInteraction s = traced.At(hits[0], ray);
        EXPECT_NEAR(s.uv.y, v, 0.03f);
        EXPECT_LT(Length(s.p - at.p), 2 * at.radius);
        EXPECT_LT(Dot(s.n, ray.d), 0);
    }
}

/// Rays that leave a curve's surface outwards do not meet the same segment again.
TEST(Curves, AreNotMetAgainByWhatLeavesThem) {
    Rng rng(5);
    CurveSet set = RandomCurves(rng, 40, 0.01f);
    set.type = CurveType::Cylinder;
    const Traced traced({Traced::Of(set)});
    int left = 0, again = 0;
    for (int k = 0; k < 4000; ++k) {
        const Ray ray{RandomPoint(rng, 1) + Vector3f{0, 0, -3}, {0, 0, 1}};
        Hit hit;
        if (!traced.accel->Intersect(ray, &hit)) continue;
        const SurfaceInteraction s = traced.At(hit, ray);
        const Vector3f w = Normalize(s.n + 0.9f * RandomDirection(rng));
        ++left;
        again += !traced.HitsWith({s.OffsetOrigin(w), w}, 0, hit.primitive).empty();
    }
    EXPECT_GT(left, 200);
    EXPECT_EQ(again, 0);
}

/// A quarter of a ring of radius 1 about 0 in the plane z = 0, as one Bezier segment.
CurveSet Bow(float radius) {
    constexpr float k = 0.5522847f;
    CurveSet c;
    c.first = {0};
    for (const Point3f p : {Point3f{1, 0, 0}, {1, k, 0}, {k, 1, 0}, {0, 1, 0}})
        c.points.push_back({p, radius});
    return c;
}

/// Not of surfaces with gaps, unlike Traced.
Accel Opaque(const std::vector<Geometry> &geometries) {
    return Accel(geometries, uint32_t(geometries.size()), {}, {}, 1);
}

/// Along -z onto the ring, `turn` of the circle from the x axis.
Ray Onto(float turn, float fromAxis) {
    const SinCos at = SinCosTurns(turn);
    return {(1 + fromAxis) * Vector3f{at.cos, at.sin, 0} + Vector3f{0, 0, 2}, {0, 0, -1}};
}

// The chords of one curve leave no wedge open outside the bend and do not count twice inside.
TEST(Curves, AreCrossedOnce) {
    Rng rng(6);
    constexpr float kRadius = 0.2f;
    const Traced traced({Traced::Of(Bow(kRadius))});
    int once = 0;
    constexpr int kRays = 20000;
    for (int i = 0; i < kRays; ++i) {
        const float turn = Lerp(rng.Uniform(), 0.02f, 0.23f);
        const float off = 0.7f * kRadius * (2 * rng.Uniform() - 1);
        once += traced.AllHits(Onto(turn, off)).size() == 1;
    }
    EXPECT_EQ(once, kRays);
}

// To within the angle of half a chord.
TEST(Curves, EndFlat) {
    const std::vector<Geometry> list{Traced::Of(Bow(0.2f))};
    const Accel accel = Opaque(list);
    Rng rng(7);
    for (int i = 0; i < 1000; ++i) {
        const float off = 0.19f * (2 * rng.Uniform() - 1),
                    beyond = Lerp(rng.Uniform(), 0.005f, 0.02f);
        for (const auto &[turn, isMet] : {std::pair{-beyond, false},
                                          {beyond, true},
                                          {0.25f - beyond, true},
                                          {0.25f + beyond, false}}) {
            const Ray ray = Onto(turn, off);
            Hit hit;
            EXPECT_EQ(accel.Intersect(ray, &hit), isMet) << turn << " " << off;
            EXPECT_EQ(accel.Occluded(ray), isMet);
            RayPacket rays;
            HitPacket hits;
            rays.Set(5, ray);
            EXPECT_EQ(accel.Intersect(rays, 1 << 5, &hits) != 0, isMet);
            EXPECT_EQ(accel.Occluded(rays, 1 << 5) != 0, isMet);
        }
    }
}

// u runs along each segment whatever its chords, and joined segments leave nothing open.
TEST(Curves, TellWhereAlongASegment) {
    constexpr float kRadius = 0.02f;
    CurveSet set = Bow(kRadius);
    set.first.push_back(3);
    for (const Point3f p : {Point3f{-0.5522847f, 1, 0}, {-1, 0.5522847f, 0}, {-1, 0, 0}})
        set.points.push_back({p, kRadius});
    const std::vector<Geometry> list{Traced::Of(set)};
    const Accel accel = Opaque(list);
    Rng rng(8);
    for (int i = 0; i < 4000; ++i) {
        const float turn = i < 2000 ? Lerp(rng.Uniform(), 0.001f, 0.499f)
                                    : 0.25f + 1e-5f * (2 * rng.Uniform() - 1);
        const float off = 0.7f * kRadius * (2 * rng.Uniform() - 1);
        Hit hit;
        ASSERT_TRUE(accel.Intersect(Onto(turn, off), &hit)) << turn;
        if (i < 2000) {
            EXPECT_EQ(hit.primitive, turn < 0.25f ? 0u : 1u);
        }
        const CurveAt at(&set.points[set.first[hit.primitive]], hit.u);
        EXPECT_LT(Length(at.p - Onto(turn, 0)(2)), 0.3f * kRadius);
    }
}

// As Embree numbers geometries: beside meshes and quadrics, in the scene and in instances.
TEST(Curves, AreMetBesideOtherShapesAndInInstances) {
    CurveSet bow = Bow(0.1f);
    bow.first.insert(bow.first.begin(), 0);  // twice, that primitive numbers matter
    TriangleMesh floor;
    floor.p = {{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}};
    floor.indices = {0, 1, 2};
    const std::vector<Geometry> list{Traced::Of(floor), Traced::Of(bow), Traced::Of(floor),
                                     Traced::Of(bow)};
    const std::vector<ObjectRange> objects{{2, 4}};
    const Transform aside = Transform::Translate({5, 0, 0});
    const Instance instance{0, AffineTransform(aside)};
    const Accel accel(list, 2, objects, std::span(&instance, 1), 1);
    for (const bool instanced : {false, true}) {
        Ray ray = Onto(0.125f, 0);
        if (instanced) ray.o.x += 5;
        Hit hit;
        ASSERT_TRUE(accel.Intersect(ray, &hit));
        EXPECT_EQ(hit.geometry, instanced ? 3u : 1u);
        EXPECT_EQ(hit.instance, instanced ? 0u : ~0u);
        EXPECT_LE(hit.primitive, 1u);
        EXPECT_NEAR(hit.u, 0.5f, 0.02f);
        EXPECT_NEAR(hit.t, 2, 1e-5f);
    }
}

}  // namespace
}  // namespace pbrt
