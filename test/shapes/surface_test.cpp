// Positions, normals, tangents and (u, v) of hits as pbrt-v4 defines them.

#include <fmt/format.h>

#include "pbrt/util/rng.h"
#include "pbrt/util/sampling.h"
#include "shapes/make.h"

namespace pbrt {
namespace {

/// Interaction where the ray from `from` to the surface point `p` ends.
SurfaceInteraction At(const Shape &shape, Point3f p, Point3f from = {0.1f, -7, 5}) {
    return SurfaceAt(shape, HitAt(1), {from, p - from});
}

constexpr float kInner = 0.70710678f;

TEST(Sphere, ConventionsOfUVAndTangents) {
    const Shape sphere = MakeOne(R"(Shape "sphere" "float radius" 2)");
    struct Case {
        Point3f p;
        Point2f uv;
        Vector3f dpdu, dpdv;
    };
    const Case cases[] = {{{2, 0, 0}, {0, 0.5f}, {0, 4 * Pi, 0}, {0, 0, 2 * Pi}},
                          {{0, 2, 0}, {0.25f, 0.5f}, {-4 * Pi, 0, 0}, {0, 0, 2 * Pi}},
                          {{-2, 0, 0}, {0.5f, 0.5f}, {0, -4 * Pi, 0}, {0, 0, 2 * Pi}},
                          {{2 * kInner, 0, 2 * kInner},
                           {0, 0.75f},
                           {0, 4 * Pi * kInner, 0},
                           {-2 * Pi * kInner, 0, 2 * Pi * kInner}}};
    for (const Case &c : cases) {
        const SurfaceInteraction s = At(sphere, c.p);
        ExpectNear(s.p, c.p, 1e-6f);
        ExpectNear(s.n, c.p * 0.5f, 1e-6f);
        EXPECT_EQ(s.ns, s.n);
        ExpectNear(s.uv, c.uv);
        ExpectNear(s.dpdu, c.dpdu, 1e-5f);
        ExpectNear(s.dpdv, c.dpdv, 1e-5f);
        EXPECT_EQ(s.dpdus, s.dpdu);
    }
    const SurfaceInteraction north = At(sphere, {0, 0, 2}), south = At(sphere, {0, 0, -2});
    EXPECT_NEAR(north.uv.y, 1, 1e-6f);
    EXPECT_NEAR(south.uv.y, 0, 1e-6f);
    for (const SurfaceInteraction &s : {north, south})
        EXPECT_GT(Length(s.dpdu), 0);
}

TEST(Sphere, PartialOnesUseTheirOwnRange) {
    const Shape s = MakeOne(R"(Shape "sphere" "float zmin" 0 "float zmax" 0.5 "float phimax" 90)");
    const float height = 0.5f, r = std::sqrt(0.75f);
    ExpectNear(At(s, {kInner, kInner, 0}).uv, Point2f{0.5f, 0}, 1e-5f);
    ExpectNear(At(s, {0, r, height}).uv, Point2f{1, 1}, 1e-5f);
}

TEST(Sphere, NormalsOfPartialOnesPointOutwards) {
    Rng rng(1);
    for (int i = 0; i < 1000; ++i) {
        const float zMin = -rng.Uniform(), zMax = zMin + 0.1f + rng.Uniform();
        const Shape shape = Sphere{{}, 1, zMin, std::min(zMax, 1.f), 1 + 5 * rng.Uniform()};
        const auto on = SampleArea(shape, 0, rng.Uniform2D());
        ASSERT_TRUE(on);
        const SurfaceInteraction s = At(shape, on->p);
        EXPECT_NEAR(Dot(s.n, s.p), 1, 1e-6f);
        EXPECT_NEAR(Dot(on->n, on->p), 1, 1e-6f);
        ExpectNear(s.uv, on->uv, 1e-5f);
    }
}

TEST(Disk, ConventionsOfUVAndTangents) {
    const Shape disk = MakeOne(
        R"(Shape "disk" "float radius" 3 "float innerradius" 1 "float height" 5 "float phimax" 180)");
    const SurfaceInteraction s = At(disk, {0, 2, 5}, {0, 2, 9});
    ExpectNear(s.p, {0, 2, 5});
    EXPECT_EQ(s.n, (Normal3f{0, 0, 1}));
    ExpectNear(s.uv, Point2f{0.5f, 0.5f});
    ExpectNear(s.dpdu, {-2 * Pi, 0, 0}, 1e-5f);
    ExpectNear(s.dpdv, {0, -2, 0}, 1e-5f);
    const Shape whole = MakeOne(R"(Shape "disk")");
    ExpectNear(At(whole, {1, 0, 0}).uv, Point2f{0, 0});
    const SurfaceInteraction center = At(whole, {0, 0, 0}, {0, 0, 4});
    EXPECT_EQ(center.uv.y, 1);
    EXPECT_GT(Length(center.dpdu), 0);
}

TEST(Cylinder, ConventionsOfUVAndTangents) {
    const Shape cylinder =
        MakeOne(R"(Shape "cylinder" "float radius" 2 "float zmin" -1 "float zmax" 3)");
    const SurfaceInteraction s = At(cylinder, {0, 2, 0});
    ExpectNear(s.p, {0, 2, 0});
    ExpectNear(s.n, {0, 1, 0});
    ExpectNear(s.uv, Point2f{0.25f, 0.25f});
    ExpectNear(s.dpdu, {-4 * Pi, 0, 0}, 1e-5f);
    ExpectNear(s.dpdv, {0, 0, 4});
}

TEST(Quadrics, NormalsTurnWithReverseOrientationNotWithMirrors) {
    const auto normal = [](std::string_view before, std::string_view shape, Point3f p) {
        return At(MakeOne(std::string(before) + " Shape " + std::string(shape)), p).n;
    };
    for (const std::string_view mirror : {"", "Scale -1 1 1"}) {
        const std::string reversed = "ReverseOrientation " + std::string(mirror);
        ExpectNear(normal(mirror, "\"sphere\"", {0, 1, 0}), {0, 1, 0});
        ExpectNear(normal(reversed, "\"sphere\"", {0, 1, 0}), {0, -1, 0});
        ExpectNear(normal(mirror, "\"cylinder\"", {0, 1, 0.2f}), {0, 1, 0});
        ExpectNear(normal(reversed, "\"cylinder\"", {0, 1, 0.2f}), {0, -1, 0});
        ExpectNear(normal(mirror, "\"disk\"", {0.2f, 0.2f, 0}), {0, 0, 1});
        ExpectNear(normal(reversed, "\"disk\"", {0.2f, 0.2f, 0}), {0, 0, -1});
    }
}

TEST(Quadrics, SampledNormalsAreThoseOfHits) {
    Rng rng(3);
    for (const std::string_view place :
         {"", "ReverseOrientation", "Scale -1 2 0.5", "Rotate 40 1 2 3 Scale 1 1 -1",
          "ReverseOrientation Rotate 40 1 2 3 Scale 3 1 -1"})
        for (const std::string_view name : {"sphere", "disk", "cylinder"}) {
            const Shape shape =
                MakeOne(std::string(place) + " Shape \"" + std::string(name) + "\"");
            for (int i = 0; i < 50; ++i) {
                const auto on = SampleArea(shape, 0, rng.Uniform2D());
                const SurfaceInteraction s = At(shape, on->p, on->p + 0.5f * on->n);
                ExpectNear(s.p, on->p, 1e-5f);
                EXPECT_GT(Dot(s.n, on->n), 0.9999f) << place << name;
                ExpectNear(s.uv, on->uv, 1e-4f);
            }
        }
}

constexpr std::string_view kTriangle = R"(Shape "trianglemesh" "point3 P" [ 0 0 0  2 0 0  0 2 0 ])";

TEST(Triangle, DefaultUVAndTangents) {
    const Shape t = MakeOne(kTriangle);
    const SurfaceInteraction s = SurfaceAt(t, HitAt(1, 0.25f, 0.5f), {});
    ExpectNear(s.p, {0.5f, 1, 0});
    ExpectNear(s.uv, Point2f{0.75f, 0.5f});
    EXPECT_EQ(s.dpdu, (Vector3f{2, 0, 0}));
    EXPECT_EQ(s.dpdv, (Vector3f{-2, 2, 0}));
    EXPECT_EQ(s.n, (Normal3f{0, 0, 1}));
    EXPECT_EQ(s.faceIndex, 0);
}

TEST(Triangle, NormalFollowsWindingReverseOrientationAndMirrors) {
    const auto normal = [](std::string_view before) {
        return SurfaceAt(MakeOne(std::string(before) + std::string(kTriangle)),
                         HitAt(1, 0.2f, 0.2f), {})
            .n;
    };
    EXPECT_EQ(normal(""), (Normal3f{0, 0, 1}));
    EXPECT_EQ(normal("ReverseOrientation "), (Normal3f{0, 0, -1}));
    EXPECT_EQ(normal("Scale -1 1 1 "), (Normal3f{0, 0, 1}));
    EXPECT_EQ(normal("Scale 1 1 -1 "), (Normal3f{0, 0, -1}));
    EXPECT_EQ(normal("ReverseOrientation Scale 1 1 -1 "), (Normal3f{0, 0, 1}));
}

TEST(Triangle, VertexNormalsDecideTheSide) {
    const std::string normals = R"( "normal N" [ 0 0 -1  0 0 -2  0 1 -1 ])";
    const Shape t = MakeOne(std::string(kTriangle) + normals);
    const SurfaceInteraction s = SurfaceAt(t, HitAt(1, 0, 0.5f), {});
    EXPECT_EQ(s.n, (Normal3f{0, 0, -1}));
    ExpectNear(s.ns, Normalize(Vector3f{0, 0.5f, -1}));
    EXPECT_GT(Dot(s.n, s.ns), 0);
    const Shape reversed = MakeOne("ReverseOrientation " + std::string(kTriangle) + normals);
    EXPECT_EQ(SurfaceAt(reversed, HitAt(1, 0, 0.5f), {}).n, (Normal3f{0, 0, 1}));
    const Shape squeezed = MakeOne("Scale 1 2 1 " + std::string(kTriangle) + normals);
    ExpectNear(SurfaceAt(squeezed, HitAt(1, 0, 1), {}).ns, Normalize(Vector3f{0, 0.5f, -1}));
}

TEST(Triangle, TangentsAndFaceIndicesGiven) {
    const Shape t =
        MakeOne(fmt::format("{} {}", kTriangle,
                            R"("vector3 S" [ 0 1 0  0 1 0  1 1 0 ] "integer faceIndices" 17
                                "point2 uv" [ 0 0  0 1  1 0 ])"));
    const SurfaceInteraction s = SurfaceAt(t, HitAt(1, 0.25f, 0.5f), {});
    EXPECT_EQ(s.faceIndex, 17);
    ExpectNear(s.dpdus, {0.5f, 1, 0});
    ExpectNear(s.uv, Point2f{0.5f, 0.25f});
    ExpectNear(s.dpdu, {0, 2, 0});
    ExpectNear(s.dpdv, {2, 0, 0});
    ExpectNear(s.ShadingFrame().x, Normalize(Vector3f{0.5f, 1, 0}));
}

TEST(Triangle, AnyShapeGivesFiniteFrames) {
    Rng rng(5);
    for (int i = 0; i < 20000; ++i) {
        TriangleMesh mesh;
        const float size = std::pow(10.f, 36 * rng.Uniform() - 18);
        for (int k = 0; k < 3; ++k) {
            mesh.p.push_back(size * SampleUniformSphere(rng.Uniform2D()));
            mesh.uv.push_back(rng.Uniform2D() * std::pow(10.f, -20 * rng.Uniform()));
            mesh.n.push_back(SampleUniformSphere(rng.Uniform2D()));
        }
        if (rng.Below(3) == 0) mesh.uv[1] = mesh.uv[0];
        if (rng.Below(3) == 0) mesh.uv[2] = 0.5f * (mesh.uv[0] + mesh.uv[1]);
        if (rng.Below(3) == 0) mesh.p[2] = 0.5f * (mesh.p[0] + mesh.p[1]);
        if (rng.Below(3) == 0) mesh.n[1] = -mesh.n[0];
        if (rng.Below(3) == 0) mesh.uv.clear();
        mesh.indices = {0, 1, 2};
        const float u = rng.Uniform();
        const Shape shape = std::move(mesh);
        const SurfaceInteraction s = SurfaceAt(shape, HitAt(1, u, (1 - u) * rng.Uniform()), {});
        for (const Vector3f v : {s.n, s.ns})
            EXPECT_NEAR(Length(v), 1, 1e-5f);
        const Frame frame = s.ShadingFrame();
        EXPECT_NEAR(LengthSquared(frame.x), 1, 1e-5f);
        // FromZTangent takes tangents down to 1e-5 rad from z, which float rounds by 6e-8.
        EXPECT_NEAR(Dot(frame.x, frame.z), 0, 6e-3f);
        EXPECT_TRUE(std::isfinite(LengthSquared(s.dpdu) / Sqr(Length(s.dpdu))));
        EXPECT_TRUE(std::isfinite(s.pError.x + s.pError.y + s.pError.z));
    }
}

TEST(Bilinear, CornersNormalAndUV) {
    const Shape patch = MakeOne(R"(Shape "bilinearmesh"
        "point3 P" [ 0 0 0  2 0 0  0 2 0  2 2 1 ])");
    EXPECT_FALSE(std::get<BilinearMesh>(patch).planar);
    const SurfaceInteraction s = SurfaceAt(patch, HitAt(1, 0.5f, 1), {});
    ExpectNear(s.p, {1, 2, 0.5f});
    ExpectNear(s.dpdu, {2, 0, 1});
    ExpectNear(s.dpdv, {0, 2, 0.5f});
    ExpectNear(s.n, Normalize(Cross(Vector3f{2, 0, 1}, {0, 2, 0.5f})));
    ExpectNear(s.uv, Point2f{0.5f, 1});
}

TEST(Bilinear, FlatPatchesRecoverTheirUV) {
    Rng rng(6);
    for (int i = 0; i < 2000; ++i) {
        BilinearMesh mesh;
        mesh.indices = {0, 1, 2, 3};
        mesh.planar = true;
        const float a = rng.Uniform(), b = rng.Uniform();
        mesh.p = {{0, 0, 1}, {1, 0.4f * a, 1}, {0.4f * b, 1, 1}, {0.8f + a, 0.8f + b, 1}};
        const Patch q = GetPatch(mesh, 0);
        const Point2f uv = rng.Uniform2D();
        const Point3f p = BilinearWeights(uv)(q);
        // Linear coordinates as traversal reports them.
        const auto solve = [](Vector3f d, Vector3f e1, Vector3f e2) {
            const float det = e1.x * e2.y - e1.y * e2.x;
            return Point2f{(d.x * e2.y - d.y * e2.x) / det, (e1.x * d.y - e1.y * d.x) / det};
        };
        Point2f linear = solve(p - q.p00, q.p10 - q.p00, q.p01 - q.p00);
        if (linear.x + linear.y > 1) {
            linear = solve(p - q.p11, q.p01 - q.p11, q.p10 - q.p11);
            linear = {1 - linear.x, 1 - linear.y};
        }
        const Shape shape = mesh;
        const SurfaceInteraction s = SurfaceAt(shape, HitAt(1, linear.x, linear.y), {});
        ExpectNear(s.p, p, 1e-6f);
        ExpectNear(s.uv, uv, 1e-5f);
    }
}

TEST(Bilinear, GivenUVAndNormals) {
    const Shape patch = MakeOne(R"(Shape "bilinearmesh"
        "point3 P" [ 0 0 0  2 0 0  0 2 0  2 2 0 ] "point2 uv" [ 0 0  0 3  3 0  3 3 ]
        "normal N" [ 0 0 -1  0 0 -1  0 0 -1  1 0 -1 ] "integer faceIndices" 5)");
    EXPECT_TRUE(std::get<BilinearMesh>(patch).planar);
    const SurfaceInteraction s = SurfaceAt(patch, HitAt(1, 0.25f, 0.5f), {});
    ExpectNear(s.uv, Point2f{1.5f, 0.75f});
    ExpectNear(s.dpdu, {0, 2 / 3.f, 0});
    ExpectNear(s.dpdv, {2 / 3.f, 0, 0});
    EXPECT_EQ(s.n, (Normal3f{0, 0, -1}));
    ExpectNear(s.ns, Normalize(Vector3f{0.125f, 0, -1}));
    EXPECT_EQ(s.faceIndex, 5);
}

TEST(Bilinear, CollapsedCornersKeepANormal) {
    const Shape patch = MakeOne(R"(Shape "bilinearmesh"
        "point3 P" [ 0 0 0  0 0 0  0 2 0  2 2 0 ])");
    EXPECT_FALSE(std::get<BilinearMesh>(patch).planar);
    for (const float u : {0.f, 0.3f, 1.f}) {
        const SurfaceInteraction s = SurfaceAt(patch, HitAt(1, u, 0), {});
        EXPECT_NEAR(std::abs(s.n.z), 1, 1e-6f);
        EXPECT_NEAR(LengthSquared(s.ShadingFrame().x), 1, 1e-5f);
    }
}

}  // namespace
}  // namespace pbrt
