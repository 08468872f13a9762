// Sixteen surface points at once are those found one by one. Both ways are the same formulas in the
// same order, but the compiler fuses multiplications and additions as it likes, so results differ
// by a few roundings of the terms that are summed up.

#include "pbrt/shapes/surface_packet.h"

#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"
#include "shapes/shape_cases.h"

namespace pbrt {
namespace {

Point3f InCube(Rng &rng, float r) {
    const float x = rng.Uniform(), y = rng.Uniform(), z = rng.Uniform();
    return r * Vector3f{2 * x - 1, 2 * y - 1, 2 * z - 1};
}
Vector3f Direction(Rng &rng) {
    return SampleUniformSphere(rng.Uniform2D());
}

/// Near a corner of the unit square: det(d uv) loses no more than a digit.
Point2f RandomUV(Rng &rng, uint32_t corner) {
    return Point2f{corner % 2 ? 1.f : 0.f, corner / 2 ? 1.f : 0.f} + 0.3f * rng.Uniform2D();
}

enum Attributes { kNormals = 1, kUV = 2, kTangents = 4, kFaces = 8, kFlip = 16 };

/// Triangles with the given attributes; one without area among them, and one whose uv have none.
TriangleMesh Triangles(Rng &rng, int attributes) {
    TriangleMesh mesh;
    for (uint32_t i = 0; i < 60; ++i) {
        mesh.indices.push_back(i);
        mesh.p.push_back(InCube(rng, 3));
        if (attributes & kNormals) mesh.n.push_back(Direction(rng));
        if (attributes & kUV) mesh.uv.push_back(RandomUV(rng, i % 3));
        if (attributes & kTangents) mesh.s.push_back(i < 6 ? Vector3f{} : Direction(rng));
        if (attributes & kFaces) mesh.faceIndices.push_back(int(rng.Below(1000)));
    }
    // Of small numbers, so that its edges' cross product is 0 however it is rounded.
    mesh.p[3] = {0, 1, 0}, mesh.p[4] = mesh.p[5] = {1, 2, -1};
    if (attributes & kUV) mesh.uv[8] = mesh.uv[7];
    mesh.flipNormal = attributes & kFlip;
    return mesh;
}

/// Flat patches: parallelograms and other convex ones.
BilinearMesh FlatPatches(Rng &rng, int attributes) {
    BilinearMesh mesh;
    for (uint32_t i = 0; i < 20; ++i) {
        const Point3f p00 = InCube(rng, 3);
        const Vector3f e1 = InCube(rng, 2), e2 = InCube(rng, 2);
        const Point2f far =
            i % 3 == 0 ? Point2f{1, 1} : Point2f{0.6f + rng.Uniform(), 0.6f + rng.Uniform()};
        mesh.p.insert(mesh.p.end(), {p00, p00 + e1, p00 + e2, p00 + far.x * e1 + far.y * e2});
        for (uint32_t k = 0; k < 4; ++k) {
            mesh.indices.push_back(4 * i + k);
            if (attributes & kNormals) mesh.n.push_back(Direction(rng));
            if (attributes & kUV) mesh.uv.push_back(RandomUV(rng, k));
        }
        if (attributes & kFaces) mesh.faceIndices.push_back(int(rng.Below(1000)));
    }
    mesh.planar = true;
    mesh.flipNormal = attributes & kFlip;
    return mesh;
}

std::vector<Shape> SomeShapes(Rng &rng) {
    std::vector<Shape> shapes;
    for (int attributes = 0; attributes < 32; attributes += 3) {
        shapes.push_back(Triangles(rng, attributes));
        shapes.push_back(FlatPatches(rng, attributes));
    }
    for (ShapeCase &c : AllCases())
        shapes.push_back(std::move(c.shape));
    for (const char *text :
         {R"(Shape "sphere" "float radius" 2)",
          R"(Translate 3 4 50 Rotate 40 1 2 3 Scale 1 -2 0.1
                                Shape "sphere" "float zmax" 0.5)",
          R"(ReverseOrientation Scale 10 10 10 Shape "sphere")",
          R"(Shape "disk" "float height" 0.2)", R"(Rotate 40 1 2 3 Shape "cylinder")",
          R"(Shape "bilinearmesh" "point3 P" [0 0 0 1 0 0 0 1 0 1 1 0.5])",
          R"(Shape "curve" "point3 P" [0 0 0 1 1 0 2 -1 1 3 0 0])"})
        shapes.push_back(MakeOne(text));
    return shapes;
}

/// A hit of a ray with a point near the shape; quadrics are hit where they are, up to 1e-5.
void RandomHit(Rng &rng, const Shape &shape, int lane, PacketHits *met) {
    Point2f uv = rng.Uniform2D();
    if (std::holds_alternative<TriangleMesh>(shape) && uv.x + uv.y > 1) uv = {1 - uv.x, 1 - uv.y};
    const uint32_t primitive = rng.Below(uint32_t(NPrimitives(shape)));
    std::optional<ShapeSample> on;  // curves cannot be sampled
    if (CanEmit(shape)) on = SampleArea(shape, primitive, rng.Uniform2D());
    const Point3f p = on ? on->p : Point3f{}, from = p + 5.f * Direction(rng);
    met->shape[size_t(lane)] = &shape;
    met->hit.t.Set(lane, 1), met->hit.u.Set(lane, uv.x), met->hit.v.Set(lane, uv.y);
    met->hit.primitive.Set(lane, primitive);
    SetLane(&met->o, lane, from);
    SetLane(&met->d, lane, p - from);
}

/// `size`: of the largest term that was summed up; ulps: how many roundings of it.
void ExpectAlike(Vector3f a, Vector3f b, float size, float ulps) {
    EXPECT_LE(MaxComponent(Abs(a - b)), ulps * 0x1p-24f * size);
}
void ExpectAlike(Point2f a, Point2f b, float size, float ulps) {
    ExpectAlike({a.x, a.y, 0}, {b.x, b.y, 0}, size, ulps);
}

/// Positions are sums of three or four terms; normals lose digits where edges are nearly parallel,
/// which the tolerance allows for by the error bound that is part of the result.
void ExpectSame(const SurfaceInteraction &a, const SurfaceInteraction &b, bool withTangents) {
    const float size = MaxComponent(Abs(b.p)) + 6;
    ExpectAlike(a.p, b.p, size, 8);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(a.pError[k], b.pError[k], 1e-3f * MaxComponent(b.pError));
    ExpectAlike(a.n, b.n, 1, 2000);
    ExpectAlike(a.ns, b.ns, 1, 2000);
    if (!withTangents) return;
    ExpectAlike(a.uv, b.uv, 1, 2000);
    ExpectAlike(a.dpdu, b.dpdu, Length(b.dpdu), 2000);
    ExpectAlike(a.dpdv, b.dpdv, Length(b.dpdv), 2000);
    ExpectAlike(a.dpdus, b.dpdus, Length(b.dpdus), 2000);
    EXPECT_EQ(a.faceIndex, b.faceIndex);
}

template <bool kWithTangents>
void Check(const PacketHits &met, LaneBits active) {
    const SurfaceInteractionX16 s = SurfacePacket<kWithTangents>(met, active);
    ForEachLane(active, [&](int i) {
        ExpectSame(Lane(s, i), SurfaceAt(*met.shape[size_t(i)], met.hit.At(i), met.RayAt(i)),
                   kWithTangents);
    });
}

TEST(SurfacePacket, AnyMixOfShapesAndAnyLanes) {
    Rng rng(1);
    const std::vector<Shape> shapes = SomeShapes(rng);
    for (int round = 0; round < 3000; ++round) {
        // Often a single shape, or a few.
        const uint32_t first = rng.Below(uint32_t(shapes.size()));
        const uint32_t count = 1 + rng.Below(uint32_t(shapes.size()) - first);
        PacketHits met{};
        const LaneBits active = round % 2 ? kAllLanes : rng.Next32() & kAllLanes;
        ForEachLane(active, [&](int i) {
            RandomHit(rng, shapes[first + rng.Below(round % 3 ? count : 1)], i, &met);
        });
        Check<true>(met, active);
        Check<false>(met, active);
    }
}

TEST(SurfaceInteractionX16, OriginsAndFramesAreThoseOfTheLanes) {
    Rng rng(2);
    for (int round = 0; round < 200; ++round) {
        SurfaceInteractionX16 s{};
        Vector3fX16 w{};
        for (int i = 0; i < kPacketSize; ++i) {
            SurfaceInteraction one;
            one.p = InCube(rng, 10), one.pError = 1e-6f * Abs(InCube(rng, 1));
            one.n = Direction(rng), one.ns = i == 3 ? Vector3f{0, 0, -1} : Direction(rng);
            // Lanes without a tangent, and with one along the normal.
            one.dpdus = i == 1 ? Vector3f{} : i == 2 ? 2.f * one.ns : InCube(rng, 4);
            SetLane(&s, i, one);
            SetLane(&w, i, Direction(rng));
        }
        const Point3fX16 o = s.OffsetOrigin(w);
        const FrameX16 f = s.ShadingFrame();
        for (int i = 0; i < kPacketSize; ++i) {
            const SurfaceInteraction one = Lane(s, i);
            ExpectAlike(Lane(o, i), one.OffsetOrigin(Lane(w, i)), 10, 2);
            const Frame frame = one.ShadingFrame();
            // x loses the digits that the tangent's part along z takes.
            const float lost =
                Length(one.dpdus) / std::max(1e-30f, Length(Cross(one.dpdus, one.ns)));
            ExpectAlike(Lane(f.x, i), frame.x, i == 2 ? 1 : std::min(lost, 1e6f), 16);
            ExpectAlike(Lane(f.y, i), frame.y, i == 2 ? 1 : std::min(lost, 1e6f), 16);
            ExpectAlike(Lane(f.z, i), frame.z, 1, 0);
        }
    }
}

}  // namespace
}  // namespace pbrt
