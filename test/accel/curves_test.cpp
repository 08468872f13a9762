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

/// How far the chords of an eighth of a segment leave it at most, from its second derivative.
float Sagitta(const CurvePoint *c) {
    const float bend =
        std::max(Length(c[0].p - 2.f * c[1].p + c[2].p), Length(c[1].p - 2.f * c[2].p + c[3].p));
    return 6 * bend / (8 * 8 * 8);
}

// A ray meets a flat curve where it passes within its radius. Eight quads a segment are its chords;
// at their joints they are cut askew, hence the 2 %.
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
        const float unsure = 0.02f + Sagitta(&set.points[set.first[segment]]) /
                                         CurveAt(&set.points[set.first[segment]], pass.u).radius;
        const bool isMet = !traced.HitsWith(ray, 0, segment).empty();
        met += isMet;
        if (std::abs(pass.radii - 1) < unsure)
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
        ray.o = at.p + (2 * v - 1) * at.radius * side - 3.f * ray.d;
        const auto hits = traced.HitsWith(ray, 0, segment);
        ASSERT_FALSE(hits.empty());
        const SurfacePoint s = traced.At(hits[0], ray);
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
        const SurfacePoint s = traced.At(hit, ray);
        const Vector3f w = Normalize(s.n + 0.9f * RandomDirection(rng));
        ++left;
        again += !traced.HitsWith({s.OffsetOrigin(w), w}, 0, hit.primitive).empty();
    }
    EXPECT_GT(left, 200);
    EXPECT_EQ(again, 0);
}

}  // namespace
}  // namespace pbrt
