// A lane of a packet meets what a single ray meets.

#include "accel/trace.h"
#include "pbrt/shapes/place_mesh.h"

namespace pbrt {
namespace {

TriangleMesh Triangles(Rng &rng, int n) {
    TriangleMesh mesh;
    for (int i = 0; i < 3 * n; ++i) {
        mesh.p.push_back(RandomPoint(rng, 2));
        mesh.uv.push_back(rng.Uniform2D());
        mesh.indices.push_back(uint32_t(i));
    }
    return mesh;
}

CurveSet Curves(Rng &rng, int n) {
    CurveSet curves;
    for (int i = 0; i < n; ++i) {
        curves.first.push_back(uint32_t(curves.points.size()));
        for (int k = 0; k < 4; ++k)
            curves.points.push_back({RandomPoint(rng, 2), 0.05f});
    }
    return curves;
}

BilinearMesh Patch(Rng &rng, bool planar) {
    const Point3f at = RandomPoint(rng, 2);
    BilinearMesh mesh;
    mesh.p = {at, at + Vector3f{1, 0, 0}, at + Vector3f{0, 1, 0},
              at + Vector3f{1, 1, planar ? 0 : 0.5f}};
    mesh.indices = {0, 1, 2, 3};
    mesh.planar = planar;
    return mesh;
}

Transform Place(Rng &rng, bool even) {
    const float size = 0.3f + 0.5f * rng.Uniform();
    return Transform::Translate(RandomPoint(rng, 2)) *
           *Transform::Rotate(360 * rng.Uniform(), RandomDirection(rng)) *
           *Transform::Scale({size, size, even ? size : 1.5f * size});
}

/// alpha(u, v) = v.
struct AlongV final : FloatNode {
    float Evaluate(const TextureEvalContext &ctx) const override { return ctx.uv.y; }
};

/// Some of each kind of shape, and of each kind of surface.
std::vector<Geometry> OfAllKinds(Rng &rng, bool cutOut, bool gaps) {
    std::vector<Shape> shapes{Triangles(rng, 20), Curves(rng, 10), Patch(rng, true),
                              Patch(rng, false)};
    for (int i = 0; i < 4; ++i) {
        shapes.push_back(Sphere{i == 0 ? Transform::Translate({1, -1, 0}) : Place(rng, i < 3)});
        shapes.push_back(Sphere{Place(rng, i < 2), 1, -0.7f, 0.6f, 5});
        shapes.push_back(Disk{Place(rng, i < 2), 0.1f, 1, 0.2f, 6});
        shapes.push_back(Cylinder{Place(rng, i < 2), 0.4f, -1, 1, i < 2 ? 2 * Pi : 4});
    }
    std::vector<Geometry> list;
    for (Shape &shape : shapes) {
        Geometry g;
        g.shape = std::move(shape);
        g.hasNullTransmission = gaps && rng.Below(8) != 0;
        if (cutOut && rng.Below(2) == 0)
            g.alpha =
                rng.Below(2) == 0 ? FloatTexture(0.6f) : FloatTexture(std::make_shared<AlongV>());
        list.push_back(std::move(g));
    }
    return list;
}

/// Shapes at top level and in an object that is repeated, at rest and in motion. `crowded`: with
/// so many instances far away that Embree is not asked to keep those at rest.
struct Everything {
    std::vector<Geometry> geometries;
    std::vector<Instance> instances;
    std::vector<ObjectRange> objects;
    std::optional<Accel> accel;

    Everything(Rng &rng, bool cutOut, bool gaps, bool crowded = false)
        : geometries(OfAllKinds(rng, cutOut, gaps)) {
        const uint32_t nTop = uint32_t(geometries.size());
        for (Geometry &g : OfAllKinds(rng, cutOut, gaps))
            geometries.push_back(std::move(g));
        objects = {{nTop, uint32_t(geometries.size())}};
        for (int i = 0; i < 4; ++i) {
            const Transform at = Transform::Translate(RandomPoint(rng, 4)) * Place(rng, false);
            const Transform then = Transform::Translate({0.3f, 0.2f, -0.5f}) * at;
            instances.push_back({0, AffineTransform(at)});
            if (i % 2 == 1)
                instances.back().later = std::make_unique<const std::vector<Transform>>(1, then);
        }
        if (crowded) AddCrowd();
        accel.emplace(geometries, nTop, objects, instances, 2);
        EXPECT_EQ(accel->Error(), "");
    }
    void AddCrowd() {
        TriangleMesh triangle;
        triangle.p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        triangle.indices = {0, 1, 2};
        const uint32_t n = uint32_t(geometries.size());
        geometries.push_back(Traced::Of(triangle));
        objects.push_back({n, n + 1});
        const AffineTransform away(Transform::Translate({1000, 0, 0}));
        while (instances.size() <= kMostEmbreeInstances)
            instances.push_back({1, away});
    }
};

Ray RandomRay(Rng &rng) {
    const Point3f o = RandomPoint(rng, 6);
    const float tMax = rng.Below(2) == 0 ? Infinity : 2 * rng.Uniform();
    return {o, RandomPoint(rng, 3) - o, tMax, rng.Uniform()};
}

/// None, all, single lanes, first lanes and any others.
LaneBits RandomLanes(Rng &rng) {
    switch (rng.Below(5)) {
        case 0:
            return rng.Below(8) == 0 ? 0 : kAllLanes;
        case 1:
            return 1u << rng.Below(16);
        case 2:
            return FirstLanes(int(rng.Below(17)));
        default:
            return rng.Next32() & kAllLanes;
    }
}

/// Lanes not in use hold no rays.
RayPacket PacketOf(Rng &rng, LaneBits active, Ray *rays) {
    RayPacket packet;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < kPacketSize; ++i) {
        rays[i] = active >> i & 1 ? RandomRay(rng) : Ray{{nan, nan, nan}, {nan, 0, nan}, nan, nan};
        packet.Set(i, rays[i]);
    }
    return packet;
}

constexpr float kUntouched = -7;

HitPacket UntouchedHits() {
    const FloatX16 f = Broadcast<16>(kUntouched);
    const UintX16 u = UintX16{} + 77;
    return {f, f, f, u, u, u};
}

void ExpectUntouched(const Hit &h) {
    EXPECT_EQ(h.t, kUntouched);
    EXPECT_EQ(h.u, kUntouched);
    EXPECT_EQ(h.v, kUntouched);
    EXPECT_EQ(h.geometry, 77u);
    EXPECT_EQ(h.primitive, 77u);
    EXPECT_EQ(h.instance, 77u);
}

/// Coordinates up to 10 are rounded at 1e-6 in an instance's space.
bool IsSame(const Hit &a, const Hit &b) {
    return a.geometry == b.geometry && a.primitive == b.primitive && a.instance == b.instance &&
           std::abs(a.t - b.t) <= 2e-6f + 1e-5f * b.t && std::abs(a.u - b.u) <= 1e-4f &&
           std::abs(a.v - b.v) <= 1e-4f;
}

/// What the lanes of packets found and how many of them differ from single rays.
struct Tally {
    int hits = 0, differ = 0;
};

Tally CompareHits(const Everything &scene, Rng &rng, int packets) {
    Tally tally;
    for (int k = 0; k < packets; ++k) {
        const LaneBits active = RandomLanes(rng);
        Ray rays[kPacketSize];
        const RayPacket packet = PacketOf(rng, active, rays);
        HitPacket hits = UntouchedHits();
        const auto coherence = Coherence(k % 3);
        const LaneBits found = scene.accel->Intersect(packet, active, &hits, coherence);
        EXPECT_EQ(found & ~active, 0u);
        for (int i = 0; i < kPacketSize; ++i) {
            if (!(found >> i & 1)) ExpectUntouched(hits.At(i));
            if (!(active >> i & 1)) continue;
            Hit single;
            const bool hit = scene.accel->Intersect(rays[i], &single);
            tally.hits += hit;
            tally.differ += hit != (found >> i & 1) || (hit && !IsSame(hits.At(i), single));
        }
    }
    return tally;
}

TEST(Packets, MeetWhatSingleRaysMeet) {
    for (int i = 0; i < 20; ++i) {
        Rng rng(uint64_t(i) + 1);
        const Everything scene(rng, i % 2 == 1, i % 4 >= 2, i % 5 == 0);
        const Tally tally = CompareHits(scene, rng, 1000);
        EXPECT_GT(tally.hits, 2000);
        // Rounding may decide at edges.
        EXPECT_LE(tally.differ, 1) << i;
    }
}

TEST(Packets, AreStoppedByWhatStopsSingleRays) {
    for (int i = 0; i < 20; ++i) {
        Rng rng(uint64_t(i) + 1);
        const Everything scene(rng, i % 2 == 1, i % 4 >= 2, i % 5 == 0);
        Tally tally;
        for (int k = 0; k < 1000; ++k) {
            const LaneBits active = RandomLanes(rng);
            Ray rays[kPacketSize];
            const RayPacket packet = PacketOf(rng, active, rays);
            const LaneBits blocked = scene.accel->Occluded(packet, active);
            EXPECT_EQ(blocked & ~active, 0u);
            ForEachLane(active, [&](int j) {
                const bool single = scene.accel->Occluded(rays[j]);
                tally.hits += single;
                tally.differ += single != (blocked >> j & 1);
            });
        }
        EXPECT_GT(tally.hits, 2000);
        EXPECT_LE(tally.differ, 1) << i;
    }
}

TEST(Packets, CrowdsOfInstancesAreMetAsFewAre) {
    for (int i = 0; i < 4; ++i) {
        Rng rng(uint64_t(i) + 1), again = rng;
        const Everything few(rng, i % 2 == 1, false), crowd(again, i % 2 == 1, false, true);
        int hits = 0, differ = 0;
        for (int k = 0; k < 5000; ++k) {
            const Ray ray = RandomRay(rng);
            Hit a, b;
            const bool metA = few.accel->Intersect(ray, &a), metB = crowd.accel->Intersect(ray, &b);
            hits += metA;
            // Embree rounds a ray into an instance in another order, which decides at edges.
            differ +=
                metA != metB || (metA && (a.geometry != b.geometry || a.instance != b.instance ||
                                          a.primitive != b.primitive));
        }
        EXPECT_GT(hits, 500);
        EXPECT_LE(differ, 10) << i;
    }
}

/// Depends on everything that a call is told.
struct Gaps final : NullTransmission {
    float operator()(const Hit &hit, const Ray &ray) const override {
        const float p = ray(hit.t).x + ray.time + float(hit.geometry) + float(hit.instance % 16);
        return hit.geometry % 8 == 0 ? 0 : 0.6f + 0.3f * std::sin(p);
    }
};

TEST(Packets, PassWhatSingleRaysPass) {
    for (int i = 0; i < 20; ++i) {
        Rng rng(uint64_t(i) + 1);
        const Everything scene(rng, i % 2 == 1, true, i % 5 == 0);
        int partly = 0, differ = 0;
        for (int k = 0; k < 1000; ++k) {
            const LaneBits active = RandomLanes(rng);
            Ray rays[kPacketSize];
            const RayPacket packet = PacketOf(rng, active, rays);
            FloatX16 passed = Broadcast<16>(kUntouched);
            scene.accel->Transmittance(packet, active, Gaps(), &passed);
            for (int j = 0; j < kPacketSize; ++j) {
                if (!(active >> j & 1)) {
                    EXPECT_EQ(passed[j], kUntouched);
                    continue;
                }
                const float single = scene.accel->Transmittance(rays[j], Gaps());
                partly += single > 0 && single < 1;
                differ += !(std::abs(single - passed[j]) <= 1e-3f * single);
            }
        }
        EXPECT_GT(partly, 300);
        EXPECT_LE(differ, 2) << i;
    }
}

}  // namespace
}  // namespace pbrt
