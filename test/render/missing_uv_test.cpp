// Meshes of several faces without uv: each face has those of its own corners, which is said once a
// shape where it shows, and changes nothing.

#include <fmt/format.h>

#include "pbrt/util/atomic_file.h"
#include "render/render_text.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

const std::string kPoints = "\"point3 P\" [ 0 0 0  1 0 0  1 1 0  0 1 0  2 0 0  2 1 0 ] ";
const std::string kTriangles =
    "Shape \"trianglemesh\" " + kPoints + "\"integer indices\" [ 0 1 2  0 2 3 ] ";
const std::string kPatches =
    "Shape \"bilinearmesh\" " + kPoints + "\"integer indices\" [ 0 1 3 2  1 4 2 5 ] ";
const std::string kUV = "\"point2 uv\" [ 0 0  .5 0  .5 1  0 1  1 0  1 1 ] ";
const std::string kBoard = "Texture \"t\" \"spectrum\" \"checkerboard\"\n";
const std::string kFloatBoard = "Texture \"f\" \"float\" \"checkerboard\"\n";

class MissingUV : public TempFolder {
  protected:
    /// What is said of a shape on line 3 or later of the file; `before` ends its line.
    std::string Said(const std::string &before, const std::string &shape) const {
        Diagnostics log;
        SceneDescription scene;
        ParseString("WorldBegin LightSource \"infinite\"\n" + before + shape, "m.pbrt",
                    folder.string(), scene, log);
        EXPECT_TRUE(BuildScene(std::move(scene), {}, log));
        std::string all;
        for (const Message &m : log.Messages())
            all += m.text + "\n";
        return all;
    }
};

TEST_F(MissingUV, IsSaidOfWhatRunsAlongThem) {
    const std::string triangles = "m.pbrt:3:1: shape \"trianglemesh\" has no uv: ",
                      laid = " are laid by each face's own corners\n";
    EXPECT_EQ(Said("Material \"featherbarbule\"\n", kTriangles), triangles + "barbules" + laid);
    EXPECT_EQ(Said("Material \"hair\"\n", kTriangles), triangles + "fibres" + laid);
    EXPECT_EQ(Said("Material \"conductor\" \"float uroughness\" .1 \"float vroughness\" .2\n",
                   kTriangles),
              triangles + "directions of roughness" + laid);
    EXPECT_EQ(Said("Material \"featherbarbule\"\n", kPatches),
              "m.pbrt:3:1: shape \"bilinearmesh\" has no uv: barbules" + laid);
}

TEST_F(MissingUV, IsSaidOfTextures) {
    const std::string said =
        "m.pbrt:4:1: shape \"trianglemesh\" has no uv: textures are laid by each face's own "
        "corners\n";
    EXPECT_EQ(Said(kBoard + "Material \"diffuse\" \"texture reflectance\" \"t\"\n", kTriangles),
              said);
    EXPECT_EQ(Said(kFloatBoard + "Material \"diffuse\"\n", kTriangles + "\"texture alpha\" \"f\""),
              said);
    // Through other textures, and through a mix.
    EXPECT_EQ(Said("Texture \"b\" \"float\" \"checkerboard\" Texture \"s\" \"float\" \"scale\" "
                   "\"texture tex\" \"b\"\nMaterial \"diffuse\"\n",
                   kTriangles + "\"texture alpha\" \"s\""),
              said);
    EXPECT_EQ(Said("MakeNamedMaterial \"a\" \"string type\" \"featherbarbule\" MakeNamedMaterial "
                   "\"b\" \"string type\" \"diffuse\"\n"
                   "Material \"mix\" \"string materials\" [ \"a\" \"b\" ]\n",
                   kTriangles),
              "m.pbrt:4:1: shape \"trianglemesh\" has no uv: barbules are laid by each face's own "
              "corners\n");
}

TEST_F(MissingUV, IsSaidOnceOfAPlyMesh) {
    Put("m.ply",
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n4 0 1 2 3\n3 1 4 2\n3 0 1 2\n");
    EXPECT_EQ(
        Said("Material \"featherbarbule\"\n", "Shape \"plymesh\" \"string filename\" \"m.ply\""),
        "m.pbrt:3:1: shape \"plymesh\" has no uv: barbules are laid by each face's own "
        "corners\n");
}

TEST_F(MissingUV, IsNoMatterElsewhere) {
    const std::string feather = "Material \"featherbarbule\"\n",
                      textured = kBoard + "Material \"diffuse\" \"texture reflectance\" \"t\"\n";
    for (const std::string &material : {feather, textured}) {
        EXPECT_EQ(Said(material, kTriangles + kUV), "");
        EXPECT_EQ(Said(material, kPatches + kUV), "");
        // A lone face's own corners are its uv.
        EXPECT_EQ(Said(material, "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]"),
                  "");
        EXPECT_EQ(
            Said(material, "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ]"),
            "");
        EXPECT_EQ(Said(material, "Shape \"sphere\" Shape \"disk\" Shape \"cylinder\""), "");
        EXPECT_EQ(Said(material, "Shape \"curve\" \"point3 P\" [ 0 0 0  1 0 0  1 1 0  2 1 0 ]"),
                  "");
    }
    EXPECT_EQ(Said("Material \"diffuse\"\n", kTriangles), "");
    EXPECT_EQ(Said("Material \"conductor\" \"float roughness\" .1\n", kTriangles), "");
    // Tangents of their own.
    EXPECT_EQ(Said(feather, kTriangles + "\"vector3 S\" [ 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 ]"),
              "");
    // Textures that look at the point, not at uv.
    EXPECT_EQ(Said("Texture \"t\" \"spectrum\" \"checkerboard\" \"string mapping\" \"planar\"\n"
                   "Material \"diffuse\" \"texture reflectance\" \"t\"\n",
                   kTriangles),
              "");
    EXPECT_EQ(Said("Texture \"t\" \"spectrum\" \"checkerboard\" \"integer dimension\" 3\n"
                   "Material \"diffuse\" \"texture reflectance\" \"t\"\n",
                   kTriangles),
              "");
}

TEST_F(MissingUV, ChangesNothing) {
    // uv written out, as pbrt-v4 gives them to each face without.
    const std::string scene =
        "LookAt 1 .5 3  1 .5 0  0 1 0\nFilm \"rgb\" \"integer xresolution\" 16 \"integer "
        "yresolution\" 16\nSampler \"zsobol\" \"integer pixelsamples\" 4\n"
        "WorldBegin\nLightSource \"infinite\"\n" +
        kFloatBoard +
        "Material \"featherbarbule\" \"float rotation\" 30 \"float tilt\" -.3\n"
        "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  1 1 0  0 0 0  1 1 0  0 1 0 ] "
        "\"integer indices\" [ 0 1 2  3 4 5 ] ";
    EXPECT_EQ(RenderText(scene).Data(),
              RenderText(scene + "\"point2 uv\" [ 0 0 1 0 1 1  0 0 1 0 1 1 ]").Data());
}

}  // namespace
}  // namespace pbrt::test
