// Laws of every type of shape as rays meet it, on the examples in its header.

#include "accel/trace.h"
#include "pbrt/shapes/surface_packet.h"
#include "shapes/shape_cases.h"

namespace pbrt {
namespace {

template <typename S>
class EveryTracedShape : public testing::Test {};
TYPED_TEST_SUITE(EveryTracedShape, test::TestTypesOf<ShapeTypes>);

/// From outside the bounds towards a point of them.
Ray RayAt(Rng &rng, const Bounds3f &b) {
    const float size = Length(b.Diagonal()) + 0.1f;
    const Point2f xy = rng.Uniform2D();
    const Vector3f d = b.Diagonal();
    const Point3f to = b.min + Vector3f{xy.x * d.x, xy.y * d.y, rng.Uniform() * d.z};
    const Point3f o = b.Center() + 1.5f * size * RandomDirection(rng);
    return {o, to - o};
}

/// f(case, traced, ray, hit) for a thousand rays at each example, of which many hit.
template <typename S, typename F>
void ForEachHit(uint64_t seed, F f) {
    Rng rng(seed);
    for (const ShapeCase &c : CasesOf<S>()) {
        const Traced traced({Traced::Of(c.shape)});
        int hits = 0;
        for (int i = 0; i < 1000; ++i) {
            const Ray ray = RayAt(rng, Bounds(c.shape));
            Hit hit;
            const bool met = traced.accel->Intersect(ray, &hit);
            EXPECT_EQ(traced.accel->Occluded(ray), met) << c.text;
            if (!met) continue;
            ++hits;
            f(c, traced, ray, hit);
        }
        EXPECT_GT(hits, 40) << c.text;
    }
}

bool IsFinite(Vector3f v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TYPED_TEST(EveryTracedShape, SurfacesLieOnTheirRaysAndInTheirBounds) {
    ForEachHit<TypeParam>(
        1, [](const ShapeCase &c, const Traced &traced, const Ray &ray, const Hit &hit) {
            const SurfaceInteraction s = traced.At(hit, ray);
            // Where the ray is at t, which is a float: at grazing angles the surface's point is off
            // along the ray by a rounding of the whole over the cosine.
            const float size = Length(ray.o) + Length(ray(hit.t));
            const float cosine = std::abs(Dot(s.n, ray.d)) / Length(ray.d);
            EXPECT_LE(Length(s.p - ray(hit.t)) * cosine, 4e-6f * size) << c.text;
            const Bounds3f b = PrimitiveBounds(c.shape, hit.primitive);
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(s.p[k], b.min[k] - s.pError[k] - 1e-6f) << c.text;
                EXPECT_LE(s.p[k], b.max[k] + s.pError[k] + 1e-6f) << c.text;
            }
        });
}

TYPED_TEST(EveryTracedShape, SurfacesHaveUnitNormalsAndFrames) {
    ForEachHit<TypeParam>(
        2, [](const ShapeCase &c, const Traced &traced, const Ray &ray, const Hit &hit) {
            const SurfaceInteraction s = traced.At(hit, ray);
            EXPECT_NEAR(Length(s.n), 1, 1e-5f) << c.text;
            EXPECT_NEAR(Length(s.ns), 1, 1e-5f) << c.text;
            EXPECT_GE(Dot(s.n, s.ns), 0) << c.text;
            const Frame frame = s.ShadingFrame();
            EXPECT_NEAR(Length(frame.x), 1, 1e-4f) << c.text;
            EXPECT_NEAR(Dot(frame.x, frame.z), 0, 6e-3f) << c.text;
            EXPECT_TRUE(IsFinite(s.dpdu) && IsFinite(s.dpdv) && IsFinite(s.pError)) << c.text;
            // What is needed without an error is the same without it.
            const SurfaceInteraction light = SurfaceAtWithoutError(c.shape, hit, ray);
            EXPECT_LE(Length(light.p - s.p), 1e-6f * (1 + Length(s.p))) << c.text;
            EXPECT_LE(Length(light.n - s.n), 1e-5f) << c.text;
            EXPECT_LE(Length(light.ns - s.ns), 1e-5f) << c.text;
            EXPECT_EQ(light.faceIndex, s.faceIndex) << c.text;
        });
}

TYPED_TEST(EveryTracedShape, NormalsTurnWithReverseOrientation) {
    std::string last;
    Shape reversed;
    ForEachHit<TypeParam>(
        3, [&](const ShapeCase &c, const Traced &traced, const Ray &ray, const Hit &hit) {
            if (c.text != last) reversed = MakeOne("ReverseOrientation " + c.text);
            last = c.text;
            const SurfaceInteraction s = traced.At(hit, ray), r = SurfaceAt(reversed, hit, ray);
            EXPECT_EQ(r.p, s.p) << c.text;
            EXPECT_EQ(r.n, -s.n) << c.text;
        });
}

TYPED_TEST(EveryTracedShape, WhatIsSampledIsMet) {
    using S = TypeParam;
    if constexpr (!S::kTraits.canEmit) GTEST_SKIP() << "cannot emit";
    Rng rng(4);
    for (const ShapeCase &c : CasesOf<S>()) {
        const Traced traced({Traced::Of(c.shape)});
        for (int i = 0; i < 500; ++i) {
            const uint32_t primitive = rng.Below(uint32_t(NPrimitives(c.shape)));
            // Off the rim, where rounding decides.
            const Point2f a = rng.Uniform2D(), u{0.01f + 0.98f * a.x, 0.01f + 0.98f * a.y};
            const auto on = SampleArea(c.shape, primitive, u);
            ASSERT_TRUE(on) << c.text;
            const Vector3f from = Normalize(on->n + 0.5f * RandomDirection(rng));
            const Ray ray{on->p + 0.25f * from, -from, 0.5f};
            float nearest = Infinity;
            Normal3f n;
            Point2f uv;
            for (const Hit &hit : traced.HitsWith(ray, 0, primitive)) {
                const SurfaceInteraction s = traced.At(hit, ray);
                if (Length(s.p - on->p) >= nearest) continue;
                nearest = Length(s.p - on->p), n = s.n, uv = s.uv;
            }
            EXPECT_LT(nearest, 2e-5f) << c.text;
            EXPECT_GT(Dot(n, on->n), 0.999f) << c.text;
            EXPECT_LT(Length(Vector3f{uv.x - on->uv.x, uv.y - on->uv.y, 0}), 1e-3f) << c.text;
        }
    }
}

/// The way of sixteen against that of one; up to what surface_packet_test allows.
TYPED_TEST(EveryTracedShape, SixteenAreMetAsEachAlone) {
    Rng rng(5);
    for (const ShapeCase &c : CasesOf<TypeParam>()) {
        const Traced traced({Traced::Of(c.shape)});
        int hits = 0, differ = 0;
        for (int round = 0; round < 60; ++round) {
            RayPacket rays;
            for (int i = 0; i < kPacketSize; ++i)
                rays.Set(i, RayAt(rng, Bounds(c.shape)));
            const LaneBits active = round % 2 ? kAllLanes : rng.Next32() & kAllLanes;
            PacketHits met{{{}, rays.o, rays.d}, {}};
            const LaneBits lanes = traced.accel->Intersect(rays, active, &met.hit);
            EXPECT_EQ(lanes & ~active, 0u);
            met.shape.fill(&c.shape);
            const SurfaceInteractionX16 s = SurfacePacket<true>(met, lanes);
            ForEachLane(active, [&](int i) {
                Hit one;
                const bool alone = traced.accel->Intersect(rays.At(i), &one);
                if (alone != bool(lanes >> i & 1) ||
                    (alone && one.primitive != met.hit.primitive[i]))
                    return void(++differ);
                if (!alone) return;
                ++hits;
                EXPECT_NEAR(met.hit.t[i], one.t, 1e-4f * one.t) << c.text;
                const SurfaceInteraction single = SurfaceAt(c.shape, met.hit.At(i), rays.At(i));
                EXPECT_LE(Length(Lane(s.p, i) - single.p), 4e-6f * (1 + Length(single.p)))
                    << c.text;
                EXPECT_LE(Length(Lane(s.n, i) - single.n), 2e-4f) << c.text;
            });
        }
        EXPECT_GT(hits, 40) << c.text;
        EXPECT_LE(differ, 2) << c.text << ": edges";
    }
}

}  // namespace
}  // namespace pbrt
