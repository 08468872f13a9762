// `pbrt --toply`: large triangle meshes go into files, and the picture stays.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "render/render_text.h"
#include "rewrite/rewriting.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

/// A wavy sheet of 2 n^2 triangles with all that a PLY file can carry.
std::string Sheet(int n, const std::string &more = "") {
    std::string p, normals, uv, indices, faces;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n, y = double(j) / n;
            p += fmt::format("{} {} {}\n", 2 * x - 1, 2 * y - 1, 0.1 * std::sin(7 * x + 5 * y));
            normals += fmt::format("{} {} -1\n", 0.7 * std::cos(7 * x + 5 * y), 0.3 * x);
            uv += fmt::format("{} {}\n", x, y * y);
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            indices +=
                fmt::format("{} {} {}  {} {} {}\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1);
            faces += fmt::format("{0} {0} ", j * n + i);
        }
    return fmt::format(
        "Shape \"trianglemesh\" \"point3 P\" [ {} ] \"normal N\" [ {} ] \"point2 uv\" [ {} ]\n"
        "\"integer indices\" [ {} ] \"integer faceIndices\" [ {} ] {}\n",
        p, normals, uv, indices, faces, more);
}

std::string SceneWith(const std::string &shapes) {
    return "Film \"rgb\" \"integer xresolution\" 24 \"integer yresolution\" 16\n"
           "Camera \"perspective\" \"float fov\" 60\nWorldBegin\n"
           "LightSource \"distant\" \"point3 from\" [ 1 2 -3 ]\nLightSource \"infinite\"\n"
           "Translate 0 0 2\nTexture \"t\" \"spectrum\" \"checkerboard\" \"float uscale\" 5\n"
           "Material \"diffuse\" \"texture reflectance\" \"t\"\n" +
           shapes;
}

class ToPly : public TempFolder {
  protected:
    std::string Turned(const std::string &text) {
        const Rewritten r = Rewrite(text, rewrite::Task::ToPly, folder.string());
        EXPECT_EQ(r.messages, "");
        return r.text;
    }
};

TEST_F(ToPly, TheSamePicture) {
    const std::string text = SceneWith(Sheet(12, "\"float alpha\" 0.7"));
    const std::string turned = Turned(text);
    EXPECT_NE(turned.find("\"plymesh\""), std::string::npos) << turned;
    EXPECT_NE(turned.find("\"float alpha\" [ 0.7 ]"), std::string::npos) << turned;
    EXPECT_EQ(turned.find("indices"), std::string::npos);
    EXPECT_EQ(FileCount(), 1u);
    const Image before = RenderText(text, {.spp = 4}),
                after = RenderText(turned, {.spp = 4}, folder.string());
    EXPECT_TRUE(std::ranges::equal(before.Data(), after.Data()));
}

TEST_F(ToPly, SmallMeshesAndMeshesWithTangentsStay) {
    const std::string small = SceneWith(Sheet(9)),  // 486 indices
        tangents = SceneWith(Sheet(12, "\"vector3 S\" [ 1 0 0 ]"));
    EXPECT_EQ(Turned(small), Formatted(small));
    EXPECT_EQ(Turned(tangents), Formatted(tangents));
    EXPECT_EQ(FileCount(), 0u);
}

TEST_F(ToPly, FilesThatAreThereStayAndServeAgain) {
    Put("mesh_00001.ply", "somebody else's");
    const std::string text = SceneWith(Sheet(12) + Sheet(13));
    const std::string once = Turned(text);
    EXPECT_NE(once.find("mesh_00002.ply"), std::string::npos);
    EXPECT_NE(once.find("mesh_00003.ply"), std::string::npos);
    EXPECT_EQ(Turned(text), once);
    EXPECT_EQ(FileCount(), 3u);
}

TEST_F(ToPly, PrefixOfTheEnvironment) {
    ASSERT_EQ(setenv("PLY_PREFIX", "sheet", 1), 0);
    const std::string turned = Turned(SceneWith(Sheet(12)));
    unsetenv("PLY_PREFIX");
    EXPECT_NE(turned.find("\"sheet_00001.ply\""), std::string::npos) << turned;
}

TEST_F(ToPly, MistakenMeshesStayWithAWarning) {
    const Rewritten r = Rewrite(SceneWith(Sheet(12, "\"normal N\" [ 0 0 1 ]")),
                                rewrite::Task::ToPly, folder.string());
    EXPECT_EQ(r.messages, "test.pbrt:9:1: a mistaken trianglemesh stays as it is\n");
    EXPECT_NE(r.text.find("trianglemesh"), std::string::npos);
}

}  // namespace
}  // namespace pbrt::test
