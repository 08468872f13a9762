#include <algorithm>
#include <numeric>

#include "pbrt/plytool/commands.h"
#include "pbrt/shapes/ply.h"
#include "pbrt/shapes/write_ply.h"
#include "pbrt/util/atomic_file.h"
#include "support/tool_test.h"

namespace pbrt::plytool {
namespace {

class PlyTool : public ToolFolder<kTool> {
  protected:
    /// A strip of `count` triangles between the rows y = 0 and y = 1.
    std::string Strip(const std::string &name, uint32_t count) const {
        std::vector<Point3f> p;
        std::vector<Point2f> uv;
        std::vector<uint32_t> indices;
        for (uint32_t i = 0; i < count + 2; ++i) {
            p.push_back({float(i) / 2, float(i % 2), 0});
            uv.push_back({float(i), 0});
        }
        for (uint32_t i = 0; i < count; ++i)
            for (uint32_t k = 0; k < 3; ++k)
                indices.push_back(i + k);
        EXPECT_EQ(WriteFileAtomically(Path(name), PlyText({p, {}, uv, indices, {}}, "test")),
                  std::nullopt);
        return Path(name);
    }
};

TEST_F(PlyTool, InfoTellsWhatAMeshHas) {
    const std::string file = Strip("a.ply", 4);
    EXPECT_EQ(Succeed({"info", file}), file +
                                           ": 6 vertices, 4 triangles, 0 quads\n"
                                           "  normals: no, uv: yes, face indices: no\n"
                                           "  bounds: (0, 0, 0) to (2.5, 1, 0)\n");
    EXPECT_NE(Fail({"info", Path("none.ply")}).find("none.ply"), std::string::npos);
}

TEST_F(PlyTool, CatPrintsShapes) {
    EXPECT_EQ(Succeed({"cat", Strip("a.ply", 1)}),
              "Shape \"trianglemesh\"\n"
              "    \"integer indices\" [ 0 1 2 ]\n"
              "    \"point3 P\" [ 0 0 0 0.5 1 0 1 0 0 ]\n"
              "    \"point2 uv\" [ 0 0 1 0 2 0 ]\n");
}

/// Corners of all triangles, in order.
std::vector<float> Corners(const std::string &file) {
    std::string problem;
    const std::optional<PlyMesh> mesh = ReadPly(file, &problem);
    EXPECT_TRUE(mesh) << problem;
    std::vector<float> corners;
    for (const uint32_t i : mesh->triangles)
        for (const float v : {mesh->p[i].x, mesh->p[i].y, mesh->uv[i].x})
            corners.push_back(v);
    return corners;
}

TEST_F(PlyTool, SplitFilesHaveTheTrianglesOfTheWhole) {
    const std::string file = Strip("a.ply", 7);
    Succeed({"split", file, "--maxfaces", "3", "--outbase", Path("part")});
    std::vector<float> joined;
    for (const char *const part : {"part-001.ply", "part-002.ply", "part-003.ply"}) {
        const std::vector<float> corners = Corners(Path(part));
        joined.insert(joined.end(), corners.begin(), corners.end());
    }
    EXPECT_EQ(joined, Corners(file));
    EXPECT_EQ(Corners(Path("part-003.ply")).size(), 9u);
    EXPECT_FALSE(std::filesystem::exists(Path("part-004.ply")));
    EXPECT_NE(Fail({"split", file, "--maxfaces", "0", "--outbase", Path("x")}).find("maxfaces"),
              std::string::npos);
}

}  // namespace
}  // namespace pbrt::plytool
