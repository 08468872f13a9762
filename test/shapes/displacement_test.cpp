#include "pbrt/shapes/displacement.h"

#include <gtest/gtest.h>

#include "shapes/make.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

/// Height as a function of uv.
template <typename F>
FloatTexture HeightOf(F f) {
    struct Node : FloatNode {
        explicit Node(F f) : f(std::move(f)) {}
        float Evaluate(const TextureEvalContext &ctx) const override { return f(ctx.uv); }
        F f;
    };
    return FloatTexture(std::make_shared<Node>(std::move(f)));
}

/// The unit square of z = 0 in two triangles, uv as x and y.
TriangleMesh Square() {
    TriangleMesh mesh;
    mesh.p = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TEST(Displacement, CutsAllEdgesAndKeepsTheMeshTogether) {
    TriangleMesh mesh = Square();
    mesh.p[2] = {3, 2, 0};  // some triangles get one cut, some two
    const Transform twice = *Transform::Scale({2, 2, 2});
    EXPECT_EQ(Displace(0.f, 0.3f, twice, &mesh), std::nullopt);
    double area = 0;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::array<uint32_t, 3> v{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const Vector3f n = Cross(mesh.p[v[1]] - mesh.p[v[0]], mesh.p[v[2]] - mesh.p[v[0]]);
        EXPECT_GT(n.z, 0);
        area += double(n.z) / 2;
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = v[k], b = v[(k + 1) % 3];
            EXPECT_LE(Length(mesh.p[a] - mesh.p[b]), 0.15f);
            ++edges[std::minmax(a, b)];
        }
    }
    EXPECT_NEAR(area, 2.5, 1e-5);
    // Edges of one triangle lie on the outline alone.
    for (const auto &[edge, count] : edges) {
        EXPECT_LE(count, 2);
        if (count == 2) continue;
        const Point3f m = 0.5f * (mesh.p[edge.first] + mesh.p[edge.second]);
        const bool isOutline = std::abs(m.x) < 1e-5f || std::abs(m.y) < 1e-5f ||
                               std::abs(m.y - (m.x - 1)) < 1e-5f ||
                               std::abs(m.y - 1 - m.x / 3) < 1e-5f;
        EXPECT_TRUE(isOutline) << m.x << ' ' << m.y;
    }
    EXPECT_EQ(mesh.faceIndices.size(), mesh.NPrimitives());
}

TEST(Displacement, MovesAlongNormalsAndBendsThem) {
    TriangleMesh mesh = Square();
    const auto height = [](Point2f uv) { return 0.1f * std::sin(6 * uv.x); };
    EXPECT_EQ(Displace(HeightOf(height), 0.02f, Transform(), &mesh), std::nullopt);
    for (size_t i = 0; i < mesh.p.size(); ++i) {
        const Point3f p = mesh.p[i];
        EXPECT_NEAR(p.z, height({p.x, p.y}), 1e-6f);
        if (p.x < 0.1f || p.x > 0.9f || p.y < 0.1f || p.y > 0.9f) continue;
        const Normal3f want = Normalize(Vector3f{-0.6f * std::cos(6 * p.x), 0, 1});
        EXPECT_GT(Dot(mesh.n[i], want), 0.9995f);
    }
    // Given normals on the other side: down, and they stay there.
    TriangleMesh turned = Square();
    turned.n.assign(4, {0, 0, -3});
    EXPECT_EQ(Displace(0.25f, 1, Transform(), &turned), std::nullopt);
    for (size_t i = 0; i < turned.p.size(); ++i) {
        EXPECT_EQ(turned.p[i].z, -0.25f);
        EXPECT_EQ(turned.n[i], (Normal3f{0, 0, -1}));
    }
}

TEST(Displacement, SaysWhatIsMissing) {
    TriangleMesh mesh = Square();
    mesh.uv.clear();
    EXPECT_EQ(Displace(1.f, 1, Transform(), &mesh),
              "has no uv, by which \"displacement\" is looked up");
    TriangleMesh fine = Square();
    const auto why = Displace(1.f, 1e-6f, Transform(), &fine);
    ASSERT_TRUE(why);
    EXPECT_EQ(*why, "\"edgelength\" 1e-06 makes about 8.8e+12 triangles, more than fit here");
}

using DisplacedPly = TempFolder;

TEST_F(DisplacedPly, QuadsBecomeTriangles) {
    Put("quad.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float u\nproperty float v\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n4 0 1 2 3\n");
    const Made made = Make(R"(Shape "plymesh" "string filename" "quad.ply" "float displacement" 2
                              "float edgelength" 0.6)",
                           folder.string());
    EXPECT_EQ(made.messages, Texts{});
    ASSERT_EQ(made.shapes.size(), 1u);
    const auto &mesh = std::get<TriangleMesh>(made.shapes[0]);
    // Sides in two, then the diagonals, which are shorter than 0.6 after that.
    EXPECT_EQ(mesh.NPrimitives(), 2u * 8);
    for (size_t i = 0; i < mesh.p.size(); ++i) {
        EXPECT_EQ(mesh.p[i].z, 2);
        EXPECT_EQ(mesh.n[i], (Normal3f{0, 0, 1}));
    }
}

}  // namespace
}  // namespace pbrt
