// Pictures of meshes whose faces take their looks from Ptex files.

#include <fmt/format.h>

#include <cmath>

#include "pbrt/ptex/ptex.h"
#include "render/render_text.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

constexpr int kSide = 4;  ///< faces along a side of the square [0, 1]^2 in the plane z = 0

/// Rows of vertices of kSide x kSide squares, and the squares' corners 00 10 01 11.
struct Grid {
    std::string points, indices;
    Grid() {
        for (int y = 0; y <= kSide; ++y)
            for (int x = 0; x <= kSide; ++x)
                points += fmt::format("{} {} 0 ", float(x) / kSide, float(y) / kSide);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const int corner = y * (kSide + 1) + x;
                indices += fmt::format("{} {} {} {} ", corner, corner + 1, corner + kSide + 1,
                                       corner + kSide + 2);
            }
    }
};

/// The square from the front under a sky of constant light.
std::string SquareScene(const std::string &world) {
    return fmt::format(R"(LookAt .5 .5 1  .5 .5 0  0 1 0
Camera "orthographic" "float screenwindow" [ -.5 .5 -.5 .5 ]
Sampler "zsobol" "integer pixelsamples" 16
PixelFilter "box" "float xradius" .5 "float yradius" .5
Integrator "path" "integer maxdepth" 1
Film "rgb" "integer xresolution" 64 "integer yresolution" 64 "string filename" "a.exr"
WorldBegin
LightSource "infinite"
{}
)",
                       world);
}

class PtexPictures : public TempFolder {
  protected:
    void Write(const PtexContent &content) const {
        EXPECT_EQ(WritePtex(Path("a.ptx"), content), std::nullopt);
    }
    Image Render(const std::string &world) const {
        return RenderText(SquareScene(world), {}, folder.string());
    }
};

/// Largest and mean difference of two pictures' values.
struct Difference {
    double largest = 0, mean = 0;
    Difference(const Image &a, const Image &b) {
        EXPECT_EQ(a.Data().size(), b.Data().size());
        for (size_t i = 0; i < a.Data().size(); ++i) {
            const double d = std::abs(a.Data()[i] - b.Data()[i]);
            largest = std::max(largest, d);
            mean += d / double(a.Data().size());
        }
    }
};

RGB FaceColor(int face) {
    return {float(face % 4) / 4 + 0.1f, float(face / 4) / 4 + 0.1f, float(face * 7 % 16) / 16};
}
float FaceRoughness(int face) {
    return float(face * 5 % 16) / 32 + 0.05f;
}
/// Where the mesh's face i finds its values: every second face of the file, from the end.
int IndexInFile(int face) {
    return 2 * (kSide * kSide - 1 - face);
}

/// The same for each face as a shape of its own with its own material.
template <typename F>
std::string FaceByFace(F material) {
    std::string world;
    for (int face = 0; face < kSide * kSide; ++face) {
        const float x = float(face % kSide) / kSide, y = float(face / kSide) / kSide;
        world += fmt::format(
            "{}\nShape \"bilinearmesh\" \"point3 P\" "
            "[ {} {} 0  {} {} 0  {} {} 0  {} {} 0 ]\n",
            material(face), x, y, x + 0.25f, y, x, y + 0.25f, x + 0.25f, y + 0.25f);
    }
    return world;
}

template <int N, typename F>
PtexContent ValuesOfFaces(F value) {
    std::vector<float> values(size_t(2 * kSide * kSide * N), 0.9f);
    for (int face = 0; face < kSide * kSide; ++face)
        for (int c = 0; c < N; ++c)
            values[size_t(IndexInFile(face) * N + c)] = value(face)[size_t(c)];
    return ConstantPtex(N, values);
}

PtexContent Colors() {
    return ValuesOfFaces<3>([](int face) {
        const RGB c = FaceColor(face);
        return std::array<float, 3>{c.r, c.g, c.b};
    });
}

std::string ColorOfFace(int face) {
    const RGB c = FaceColor(face);
    return fmt::format("Material \"diffuse\" \"rgb reflectance\" [ {} {} {} ]", c.r, c.g, c.b);
}

constexpr char kColoredByFile[] = R"(
Texture "faces" "spectrum" "ptex" "string filename" "a.ptx" "string encoding" "linear"
Material "diffuse" "texture reflectance" "faces"
)";

TEST_F(PtexPictures, EachFaceHasItsColor) {
    Write(Colors());
    std::string faces;
    for (int face = 0; face < kSide * kSide; ++face)
        faces += fmt::format("{} ", IndexInFile(face));
    const Grid grid;
    const Image got =
        Render(kColoredByFile +
               fmt::format("Shape \"bilinearmesh\" \"point3 P\" [ {} ] \"integer indices\" [ {} ]"
                           " \"integer faceIndices\" [ {} ]",
                           grid.points, grid.indices, faces));
    const Image expected = Render(FaceByFace(ColorOfFace));
    // One sky, one bounce: the same samples see the same spectra but for rounding.
    EXPECT_LT(Difference(got, expected).largest, 1e-3);
    EXPECT_GT(
        Difference(
            got, Render("Material \"diffuse\"" +
                        fmt::format(
                            "Shape \"bilinearmesh\" \"point3 P\" [ {} ] \"integer indices\" [ {} ]",
                            grid.points, grid.indices)))
            .mean,
        0.1);
}

TEST_F(PtexPictures, PlyFilesCarryFaceIndices) {
    // Quads and pairs of triangles in turn, in file order as face_indices say.
    Write(Colors());
    std::string rows;
    int nFaces = 0;
    const auto add = [&](int face, std::initializer_list<int> corners) {
        rows += fmt::format("{}", corners.size());
        for (const int c : corners)
            rows += fmt::format(" {}", c);
        rows += fmt::format(" {}\n", IndexInFile(face));
        ++nFaces;
    };
    for (int face = 0; face < kSide * kSide; ++face) {
        const int c = face / kSide * (kSide + 1) + face % kSide, up = c + kSide + 1;
        if (face % 2) {
            add(face, {c, c + 1, up + 1, up});
        } else {
            add(face, {c, c + 1, up + 1});
            add(face, {c, up + 1, up});
        }
    }
    Put("a.ply", fmt::format("ply\nformat ascii 1.0\nelement vertex 25\nproperty float x\n"
                             "property float y\nproperty float z\nelement face {}\n"
                             "property list uchar int vertex_indices\nproperty int face_indices\n"
                             "end_header\n{}\n{}",
                             nFaces, Grid().points, rows));
    const Image got =
        Render(kColoredByFile + std::string("Shape \"plymesh\" \"string filename\" \"a.ply\""));
    EXPECT_LT(Difference(got, Render(FaceByFace(ColorOfFace))).largest, 1e-3);
}

TEST_F(PtexPictures, WithoutFaceIndicesPrimitivesCount) {
    PtexContent content = Colors();
    PtexContent inOrder = ConstantPtex(3, std::vector<float>(3 * kSide * kSide));
    for (int face = 0; face < kSide * kSide; ++face)
        for (int c = 0; c < 3; ++c)
            inOrder.texels[size_t(3 * face + c)] =
                content.texels[size_t(3 * IndexInFile(face) + c)];
    Write(inOrder);
    const Grid grid;
    const Image got =
        Render(kColoredByFile + fmt::format("Shape \"bilinearmesh\" \"point3 P\" [ {} ] \"integer "
                                            "indices\" [ {} ]",
                                            grid.points, grid.indices));
    EXPECT_LT(Difference(got, Render(FaceByFace(ColorOfFace))).largest, 1e-3);
}

TEST_F(PtexPictures, EachFaceHasItsRoughness) {
    Write(ValuesOfFaces<1>([](int face) { return std::array<float, 1>{FaceRoughness(face)}; }));
    const auto material = [](const std::string &roughness) {
        return "Material \"conductor\" \"bool remaproughness\" false " + roughness + "\n";
    };
    std::string faces;
    for (int face = 0; face < kSide * kSide; ++face)
        faces += fmt::format("{} ", IndexInFile(face));
    const Grid grid;
    // A lamp beside the camera: how rough a face is shows in its highlight.
    const std::string lamp = "LightSource \"point\" \"point3 from\" [ .5 .5 2 ]\n";
    const Image got = Render(
        lamp +
        R"(Texture "faces" "float" "ptex" "string filename" "a.ptx" "string encoding" "linear")" +
        material("\"texture roughness\" \"faces\"") +
        fmt::format("Shape \"bilinearmesh\" \"point3 P\" [ {} ] \"integer indices\" [ {} ]"
                    " \"integer faceIndices\" [ {} ]",
                    grid.points, grid.indices, faces));
    const Image expected =
        Render(lamp + FaceByFace([&](int face) {
                   return material(fmt::format("\"float roughness\" {}", FaceRoughness(face)));
               }));
    const Image uniform =
        Render(lamp + FaceByFace([&](int) { return material("\"float roughness\" .3"); }));
    // Single samples of the sky by the lobe; the lamp dominates.
    EXPECT_LT(Difference(got, expected).mean, 1e-3);
    EXPECT_GT(Difference(uniform, expected).mean, 0.05);
}

TEST_F(PtexPictures, TexelsAcrossFacesLookLikeAnAtlas) {
    // 8 x 8 texels a face, the faces joined, against one picture over the whole square.
    constexpr int n = 8, all = n * kSide;
    const auto color = [](int x, int y, int c) {
        return 0.5f + 0.4f * std::sin(float(x * (c + 1)) * 0.3f + float(y) * 0.4f);
    };
    PtexContent content;
    content.nChannels = 3;
    Image atlas({all, all}, {"R", "G", "B"});
    for (int face = 0; face < kSide * kSide; ++face) {
        const int fx = face % kSide, fy = face / kSide;
        PtexFace info{3, 3};
        const std::array<Point2i, 4> next{Point2i{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
        for (size_t e = 0; e < 4; ++e) {
            const int x = fx + next[e].x, y = fy + next[e].y;
            if (x < 0 || x >= kSide || y < 0 || y >= kSide) continue;
            info.neighbours[e] = y * kSide + x;
            info.neighbourEdges[e] = int(e + 2) % 4;
        }
        content.faces.push_back(info);
        for (int y = fy * n; y < (fy + 1) * n; ++y)
            for (int x = fx * n; x < (fx + 1) * n; ++x)
                for (int c = 0; c < 3; ++c) {
                    content.texels.push_back(color(x, y, c));
                    atlas.Set({x, all - 1 - y}, c, color(x, y, c));
                }
    }
    Write(content);
    EXPECT_EQ(WriteImage(atlas, Path("atlas.exr"), ExrPixels::Float), std::nullopt);
    const Grid grid;
    const std::string mesh =
        fmt::format("Shape \"bilinearmesh\" \"point3 P\" [ {} ] \"integer indices\" [ {} ] ",
                    grid.points, grid.indices);
    std::string uv;
    for (int i = 0; i < (kSide + 1) * (kSide + 1); ++i)
        uv += fmt::format("{} {} ", float(i % (kSide + 1)) / kSide, float(i / (kSide + 1)) / kSide);
    const Image got = Render(kColoredByFile + mesh);
    const Image expected = Render(
        R"(Texture "t" "spectrum" "imagemap" "string filename" "atlas.exr" "string wrap" "clamp"
        Material "diffuse" "texture reflectance" "t")" +
        ("\n" + mesh) + "\"point2 uv\" [ " + uv + " ]");
    // The footprint, an eighth of a texel, blunts the kinks of the interpolation by a 64th of the
    // change of slope, which is at most 0.4 * 0.98^2 per texel.
    EXPECT_LT(Difference(got, expected).largest, 0.4 / 64 + 1e-3);
    EXPECT_LT(Difference(got, expected).mean, 1e-3);
}

}  // namespace
}  // namespace pbrt::test
