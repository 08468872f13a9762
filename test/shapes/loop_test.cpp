#include "pbrt/shapes/loop_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pbrt/util/rng.h"
#include "shapes/make.h"

namespace pbrt::test {
namespace {

struct Control {
    std::vector<Point3f> p;
    std::vector<uint32_t> indices;

    LoopMesh Mesh(int levels = 0) const {
        LoopMesh mesh(p, indices);
        for (int i = 0; i < levels; ++i)
            mesh = mesh.Subdivided();
        return mesh;
    }
};

/// n triangles about vertex 0, closed or not, with a second ring of triangles about them; heights
/// at random.
Control Fan(int n, bool isClosed, float height, uint64_t seed) {
    Rng rng(seed);
    Control c;
    c.p.push_back({0, 0, height * rng.Uniform()});
    const int spokes = isClosed ? n : n + 1;
    const float angle = (isClosed ? 2 * Pi : Pi) / float(isClosed ? n : std::max(n, 2));
    for (int ring = 1; ring <= 2; ++ring)
        for (int i = 0; i < spokes; ++i)
            c.p.push_back({float(ring) * std::cos(float(i) * angle),
                           float(ring) * std::sin(float(i) * angle), height * rng.Uniform()});
    for (int i = 0; i < n; ++i) {
        const uint32_t a = uint32_t(1 + i), b = uint32_t(1 + (i + 1) % spokes);
        const uint32_t outerA = a + uint32_t(spokes), outerB = b + uint32_t(spokes);
        c.indices.insert(c.indices.end(), {0, a, b, a, outerA, outerB, a, outerB, b});
    }
    return c;
}

std::vector<Control> Fans(float height) {
    std::vector<Control> fans;
    for (int n = 3; n <= 8; ++n)
        fans.push_back(Fan(n, true, height, uint64_t(n)));
    for (int n = 1; n <= 6; ++n)
        fans.push_back(Fan(n, false, height, uint64_t(10 + n)));
    return fans;
}

Control Octahedron() {
    return {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
            {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 5, 2, 1, 5, 3, 2, 5, 4, 3, 5, 1, 4}};
}
Control Icosahedron() {
    const float g = (1 + std::sqrt(5.f)) / 2;
    return {{{-1, g, 0},
             {1, g, 0},
             {-1, -g, 0},
             {1, -g, 0},
             {0, -1, g},
             {0, 1, g},
             {0, -1, -g},
             {0, 1, -g},
             {g, 0, -1},
             {g, 0, 1},
             {-g, 0, -1},
             {-g, 0, 1}},
            {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
             4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
             6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1}};
}

TEST(Loop, APlaneStaysAPlane) {
    for (const Control &fan : Fans(0)) {
        const LoopMesh mesh = fan.Mesh(3);
        for (uint32_t v = 0; v < uint32_t(mesh.NVertices()); ++v) {
            EXPECT_EQ(mesh.LimitPosition(v).z, 0);
            const Normal3f n = mesh.LimitNormal(v);
            EXPECT_NEAR(n.z, 1, 1e-5f) << n.x << ' ' << n.y;
        }
    }
}

/// Vertices keep their number; twelve steps are at the limit but for the square of 2^-12 and less.
TEST(Loop, LimitPositionsAreWhereSubdivisionLeads) {
    for (const Control &fan : Fans(1)) {
        const LoopMesh coarse = fan.Mesh();
        LoopMesh fine = coarse;
        // Only what is near vertex 0 matters: a few steps of all of it suffice for 1e-4.
        for (int i = 0; i < 7; ++i)
            fine = fine.Subdivided();
        for (uint32_t v = 0; v < uint32_t(coarse.NVertices()); ++v)
            EXPECT_LT(Length(coarse.LimitPosition(v) - fine.Position(v)), 2e-4f) << v;
    }
}

/// So are those of each step's mesh: one more step changes nothing.
TEST(Loop, LimitsAreTheSameAfterEachStep) {
    std::vector<Control> all = Fans(1);
    all.push_back(Octahedron());
    all.push_back(Icosahedron());
    for (const Control &control : all) {
        const LoopMesh coarse = control.Mesh(1), fine = coarse.Subdivided();
        for (uint32_t v = 0; v < uint32_t(coarse.NVertices()); ++v) {
            EXPECT_LT(Length(coarse.LimitPosition(v) - fine.LimitPosition(v)), 1e-6f) << v;
            EXPECT_LT(Length(coarse.LimitNormal(v) - fine.LimitNormal(v)), 2e-5f) << v;
        }
    }
}

/// Regular vertices: twelve control points' box spline, whose value at a vertex is half of it and a
/// twelfth of each neighbour; three neighbours: 2/5 and 1/5.
TEST(Loop, LimitPositionsInClosedForm) {
    for (const auto &[n, own] :
         {std::pair{6, 1. / 2}, std::pair{3, 2. / 5}, std::pair{4, 1. / 2}, std::pair{8, 1. / 2}}) {
        const Control fan = Fan(n, true, 1, 77);
        double ring = 0;
        for (int i = 1; i <= n; ++i)
            ring += double(fan.p[size_t(i)].z) / n;
        EXPECT_NEAR(fan.Mesh().LimitPosition(0).z, own * double(fan.p[0].z) + (1 - own) * ring,
                    1e-6)
            << n;
    }
    // On boundaries the uniform cubic B-spline.
    const Control half = Fan(4, false, 1, 78);
    EXPECT_NEAR(half.Mesh().LimitPosition(0).z, (4 * half.p[0].z + half.p[1].z + half.p[5].z) / 6,
                1e-6);
}

/// The triangles about a vertex turn towards its tangent plane.
TEST(Loop, NormalsAreThoseOfTheLimit) {
    for (const Control &fan : Fans(0.4f)) {
        const LoopMesh coarse = fan.Mesh(), fine = fan.Mesh(7);
        for (uint32_t v = 0; v < uint32_t(coarse.NVertices()); ++v) {
            const Normal3f n = coarse.LimitNormal(v);
            ASSERT_NEAR(Length(n), 1, 1e-5f);
            const std::vector<uint32_t> &corners = fine.Indices();
            for (size_t i = 0; i < corners.size(); ++i) {
                if (corners[i] != v) continue;
                // Finite differences of the surface, from neighbours on it: with valence 8 they
                // fall slowest, as (0.375 / 0.552)^7 = 0.07 of slopes up to 0.4.
                const Point3f a = fine.LimitPosition(v);
                const Point3f b = fine.LimitPosition(corners[i / 3 * 3 + (i + 1) % 3]);
                const Point3f c = fine.LimitPosition(corners[i / 3 * 3 + (i + 2) % 3]);
                EXPECT_NEAR(Dot(Normalize(b - a), n), 0, 0.05f) << v;
                EXPECT_NEAR(Dot(Normalize(c - a), n), 0, 0.05f) << v;
                EXPECT_GT(Dot(Normalize(Cross(b - a, c - a)), n), 0.9f) << v;
            }
        }
    }
}

TEST(Loop, ClosedMeshesStayClosedAndBecomeRound) {
    for (const Control &control : {Octahedron(), Icosahedron()}) {
        size_t vertices = control.p.size(), triangles = control.indices.size() / 3;
        LoopMesh mesh = control.Mesh();
        for (int level = 1; level <= 4; ++level) {
            vertices += triangles * 3 / 2;
            triangles *= 4;
            mesh = mesh.Subdivided();
            EXPECT_EQ(mesh.NVertices(), vertices);
            EXPECT_EQ(mesh.Indices().size(), 3 * triangles);
        }
        float least = Infinity, most = 0, cosine = 1;
        for (uint32_t v = 0; v < uint32_t(mesh.NVertices()); ++v) {
            const Vector3f p = mesh.LimitPosition(v);
            least = std::min(least, Length(p)), most = std::max(most, Length(p));
            cosine = std::min(cosine, Dot(Normalize(p), mesh.LimitNormal(v)));
        }
        const bool isFine = control.p.size() == 12;
        EXPECT_LT(most / least, isFine ? 1.04f : 1.25f);
        EXPECT_GT(cosine, isFine ? 0.995f : 0.95f);
    }
}

TEST(Loop, CutsWhatIsNoSurface) {
    // Two triangles that touch in a point; three on one edge; two that run the same way along one.
    const std::vector<Point3f> p{{0, 0, 0},  {1, 0, 0},  {0, 1, 0},
                                 {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    const LoopMesh tie(p, {0, 1, 2, 0, 3, 4});
    EXPECT_EQ(tie.NVertices(), 6u);
    const LoopMesh three(p, {0, 1, 2, 1, 0, 4, 0, 1, 5});
    EXPECT_EQ(three.NVertices(), 9u);
    const LoopMesh same(p, {0, 1, 2, 0, 1, 4});
    EXPECT_EQ(same.NVertices(), 6u);
    for (const LoopMesh &mesh : {tie, three, same}) {
        const LoopMesh fine = mesh.Subdivided().Subdivided();
        EXPECT_EQ(fine.Indices().size(), 16 * mesh.Indices().size());
        for (uint32_t v = 0; v < uint32_t(fine.NVertices()); ++v)
            EXPECT_NEAR(Length(fine.LimitNormal(v)), 1, 1e-5f);
    }
}

TEST(LoopSubdiv, IsATriangleMeshOfTheLimit) {
    const Shape made = MakeOne(R"(Translate 0 0 5
        Shape "loopsubdiv" "integer levels" 2 "string scheme" "loop"
          "integer indices" [ 0 1 2  0 2 3  0 3 4  0 4 1  5 2 1  5 3 2  5 4 3  5 1 4 ]
          "point3 P" [ 0 0 1  1 0 0  0 1 0  -1 0 0  0 -1 0  0 0 -1 ])");
    const auto &mesh = std::get<TriangleMesh>(made);
    ASSERT_EQ(mesh.NPrimitives(), 8u * 16);
    EXPECT_EQ(mesh.p.size(), mesh.n.size());
    // Valence 4: half of the vertex.
    EXPECT_NEAR(mesh.p[0].z, 5.5f, 1e-6f);
    EXPECT_NEAR(mesh.n[0].z, 1, 1e-6f);
}

TEST(LoopSubdiv, SaysWhatCannotBe) {
    const std::string triangle = R"(Shape "loopsubdiv" "point3 P" [ 0 0 0  1 0 0  0 1 0 ])";
    EXPECT_EQ(Make(triangle + R"("integer indices" [ 0 1 1 ])").messages,
              Texts{R"(test.pbrt:2:54: shape "loopsubdiv": triangle 0 has a point twice)"});
    EXPECT_EQ(Make(triangle + R"("integer levels" 17)").messages,
              Texts{R"(test.pbrt:2:71: "integer levels": 17 is outside [0, 16])"});
    EXPECT_EQ(
        Make(triangle + R"("integer levels" 16)").messages,
        Texts{R"(test.pbrt:2:1: shape "loopsubdiv": 4294967296 triangles are more than fit here)"});
}

}  // namespace
}  // namespace pbrt::test
