// PLY files of every kind are read as they were written; damaged ones are errors.

#include "pbrt/shapes/ply.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdlib>

#include "pbrt/util/rng.h"
#include "shapes/make.h"
#include "shapes/ply_files.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

class Ply : public TempFolder {
  protected:
    std::optional<PlyMesh> Read(const std::string &bytes, const std::string &name = "a.ply") {
        Put(name, bytes);
        problem.clear();
        return ReadPly(Path(name), &problem);
    }
    std::string problem;
};

/// How a test file is laid out.
struct Layout {
    PlyKind kind;
    bool doubles = false, normals = false, extras = false, wideCounts = false, faceIndices = false;
    const char *u = nullptr, *v = nullptr;
};

PlyMesh RandomMesh(Rng &rng, const Layout &layout, int nVertices, int nFaces) {
    PlyMesh mesh;
    for (int i = 0; i < nVertices; ++i) {
        mesh.p.push_back({rng.Uniform() - 0.5f, 1e4f * rng.Uniform(), -1e-5f * rng.Uniform()});
        if (layout.normals) mesh.n.push_back({rng.Uniform(), rng.Uniform(), -rng.Uniform()});
        if (layout.u) mesh.uv.push_back(rng.Uniform2D());
    }
    for (int i = 0; i < nFaces; ++i) {
        const bool isQuad = rng.Below(10) == 0;
        auto &indices = isQuad ? mesh.quads : mesh.triangles;
        for (int k = 0; k < (isQuad ? 4 : 3); ++k)
            indices.push_back(rng.Below(uint32_t(nVertices)));
        if (layout.faceIndices) (isQuad ? mesh.quadFaces : mesh.triangleFaces).push_back(i * 7);
    }
    return mesh;
}

std::string Written(const Layout &layout, const PlyMesh &mesh) {
    PlyWriter w(layout.kind);
    const std::string real = layout.doubles ? "double" : "float";
    const auto put = [&](float x) { layout.doubles ? w.Put(double(x)) : w.Put(x); };
    w.Line(fmt::format("element vertex {}", mesh.p.size()));
    if (layout.extras) w.Line("property uchar red\nproperty list uchar short neighbours");
    for (const char *axis : {"x", "y", "z"})
        w.Line("property " + real + " " + axis);
    if (layout.normals)
        for (const char *axis : {"nx", "ny", "nz"})
            w.Line("property float32 " + std::string(axis));
    if (layout.u)
        for (const char *name : {layout.u, layout.v})
            w.Line("property float " + std::string(name));
    if (layout.extras) w.Line("element edge 2\nproperty list int double weights");
    w.Line(fmt::format("element face {}", (mesh.triangles.size() / 3 + mesh.quads.size() / 4)));
    if (layout.extras) w.Line("property uchar flags");
    w.Line(layout.wideCounts ? "property list int32 uint32 vertex_index"
                             : "property list uchar int vertex_indices");
    if (layout.faceIndices) w.Line("property int face_indices");
    w.Line("end_header");

    for (size_t i = 0; i < mesh.p.size(); ++i) {
        if (layout.extras) {
            w.Put(uint8_t(i));
            w.Put(uint8_t(i % 3));
            for (size_t k = 0; k < i % 3; ++k)
                w.Put(int16_t(-5));
        }
        for (int k = 0; k < 3; ++k)
            put(mesh.p[i][k]);
        for (int k = 0; layout.normals && k < 3; ++k)
            w.Put(mesh.n[i][k]);
        for (int k = 0; layout.u && k < 2; ++k)
            w.Put(mesh.uv[i][k]);
        w.EndRow();
    }
    if (layout.extras)
        for (int i = 0; i < 2; ++i) {
            w.Put(int32_t(i));
            for (int k = 0; k < i; ++k)
                w.Put(2.5);
            w.EndRow();
        }
    // Quads among the triangles, as their face indices say; without those, first.
    size_t t = 0, q = 0;
    while (3 * t < mesh.triangles.size() || 4 * q < mesh.quads.size()) {
        const bool triangleNext =
            4 * q == mesh.quads.size() || (layout.faceIndices && 3 * t < mesh.triangles.size() &&
                                           mesh.triangleFaces[t] < mesh.quadFaces[q]);
        const int n = triangleNext ? 3 : 4;
        if (layout.extras) w.Put(uint8_t(1));
        layout.wideCounts ? w.Put(int32_t(n)) : w.Put(uint8_t(n));
        // Round the edge; patches are stored 00 10 01 11.
        constexpr size_t kRound[] = {0, 1, 3, 2};
        for (size_t k = 0; k < size_t(n); ++k)
            w.Put(triangleNext ? mesh.triangles[3 * t + k] : mesh.quads[4 * q + kRound[k]]);
        if (layout.faceIndices)
            w.Put(int32_t(triangleNext ? mesh.triangleFaces[t] : mesh.quadFaces[q]));
        w.EndRow();
        ++(triangleNext ? t : q);
    }
    return w.Text();
}

void ExpectSame(const PlyMesh &a, const PlyMesh &b) {
    EXPECT_EQ(a.p, b.p);
    EXPECT_EQ(a.n, b.n);
    EXPECT_EQ(a.uv, b.uv);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.quads, b.quads);
    EXPECT_EQ(a.triangleFaces, b.triangleFaces);
    EXPECT_EQ(a.quadFaces, b.quadFaces);
    EXPECT_EQ(a.otherFaces, 0u);
}

TEST_F(Ply, RoundTripsOfAllLayouts) {
    Rng rng(1);
    const char *const uvNames[5][2] = {{nullptr, nullptr},
                                       {"u", "v"},
                                       {"s", "t"},
                                       {"texture_u", "texture_v"},
                                       {"texture_s", "texture_t"}};
    for (const PlyKind kind : {PlyKind::Ascii, PlyKind::Little, PlyKind::Big})
        for (int bits = 0; bits < 32; ++bits) {
            const auto &uv = uvNames[(bits + int(kind)) % 5];
            const Layout layout{kind,
                                (bits & 1) != 0,
                                (bits & 2) != 0,
                                (bits & 4) != 0,
                                (bits & 8) != 0,
                                (bits & 16) != 0,
                                uv[0],
                                uv[1]};
            const PlyMesh mesh = RandomMesh(rng, layout, 50, 80);
            const std::string bytes = Written(layout, mesh);
            for (const bool gzipped : {false, true}) {
                const auto read =
                    Read(gzipped ? Gzipped(bytes) : bytes, gzipped ? "a.ply.gz" : "a.ply");
                ASSERT_TRUE(read) << problem << "\n" << bytes.substr(0, 600);
                ExpectSame(*read, mesh);
            }
        }
}

TEST_F(Ply, FilesLargerThanTheWindow) {
    Rng rng(2);
    for (const PlyKind kind : {PlyKind::Ascii, PlyKind::Little}) {
        const Layout layout{kind, false, true, false, false, false, "u", "v"};
        const PlyMesh mesh = RandomMesh(rng, layout, 30000, 60000);
        const std::string bytes = Written(layout, mesh);
        for (const bool gzipped : {false, true}) {
            const auto read = Read(gzipped ? Gzipped(bytes) : bytes);
            ASSERT_TRUE(read) << problem;
            ExpectSame(*read, mesh);
        }
    }
}

const std::string kTriangleHead =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST_F(Ply, AsciiSpellings) {
    const auto read = Read(
        "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\n"
        "property float y\r\nproperty float z\r\nelement face 1\r\n"
        "property list uchar int vertex_indices\r\nend_header\r\n"
        "+1 -2.5e1 1e-50\r\n\r\n  0\t0 0 1 1 1\r\n3 0 1 2");
    ASSERT_TRUE(read) << problem;
    EXPECT_EQ(read->p[0], (Point3f{1, -25, 0}));
    EXPECT_EQ(read->triangles, (std::vector<uint32_t>{0, 1, 2}));
}

TEST_F(Ply, AsciiNumbersTooSmallForDoubleAreZero) {
    const std::optional<PlyMesh> mesh = Read(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "1.5e-400 -1.5e-400 1\n1 0 0\n0 1 0\n3 0 1 2\n");
    ASSERT_TRUE(mesh) << problem;
    EXPECT_EQ(mesh->p[0], (Point3f{0, 0, 1}));
}

TEST_F(Ply, OtherPolygonsAreCountedAndLeftOut) {
    const auto read = Read(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1\n5 0 1 2 3 4\n3 0 1 2\n2 0 1\n0\n");
    ASSERT_TRUE(read) << problem;
    EXPECT_EQ(read->otherFaces, 3u);
    EXPECT_EQ(read->triangles, (std::vector<uint32_t>{0, 1, 2}));
}

struct Damage {
    std::string bytes, problem;
};

std::string Replaced(std::string text, const std::string &what, const std::string &by) {
    const size_t at = text.find(what);
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST_F(Ply, DamagedFilesSayWhatIsWrong) {
    const std::string good = kTriangleHead + "0 0 0 1 0 0 0 1 0\n3 0 1 2\n";
    ASSERT_TRUE(Read(good));
    const auto head = [&](const std::string &what, const std::string &by) {
        return Replaced(good, what, by);
    };
    const std::string binary =
        Replaced(kTriangleHead, "ascii", "binary_little_endian") + std::string(36, '\0');
    const std::string zipped = Gzipped(good);
    std::string flipped = zipped;
    flipped[flipped.size() - 6] = char(flipped[flipped.size() - 6] ^ 1);  // in the checksum
    const Damage cases[] = {
        {"", "is no PLY file: it does not start with \"ply\""},
        {"plyx\n", "is no PLY file: it does not start with \"ply\""},
        {"solid\nfacet", "is no PLY file: it does not start with \"ply\""},
        {std::string(100000, 'x'), "is no PLY file: it does not start with \"ply\""},
        {"ply\nformat ascii 1.0\n", "ends before \"end_header\""},
        {"ply\nformat ascii 1.0\ncomment " + std::string(5000, 'x') + "\nend_header\n",
         "ends before \"end_header\""},
        {head("format ascii 1.0\n", ""), "its header has no \"format\" line"},
        {head("ascii", "text"), "header line 2 is not understood: \"format text 1.0\""},
        {head("1.0", "2.0"), "header line 2 is not understood: \"format ascii 2.0\""},
        {head("property float y", "property quaternion y"),
         "header line 5 is not understood: \"property quaternion y\""},
        {head("property float y", "property float x"),
         "header line 5 is not understood: \"property float x\""},
        {head("property float y", "propperty float y"),
         "header line 5 is not understood: \"propperty float y\""},
        {head("element vertex 3", "element vertex -3"),
         "header line 3 is not understood: \"element vertex -3\""},
        {head("element vertex 3", "element vertex 99999999999"),
         "header line 3 is not understood: \"element vertex 99999999999\""},
        {head("element vertex 3\n", ""), "header line 3 is not understood: \"property float x\""},
        {head("element face", "element vertex"),
         "header line 7 is not understood: \"element vertex 1\""},
        {head("element vertex", "element corner"), "has no \"element vertex\""},
        {head("element face", "element side"), "has no \"element face\""},
        {head("float z", "float w"), "its vertices have no x, y and z"},
        {head("list uchar int", "list uchar float"),
         "its faces have no list of integers \"vertex_indices\""},
        {head("list uchar int", "list float int"),
         "header line 8 is not understood: \"property list float int vertex_indices\""},
        {head("list uchar int", "int"), "its faces have no list of integers \"vertex_indices\""},
        {head("element vertex 3", "element vertex 4000000000"),
         "is too short: 4000000000 x \"vertex\" need at least 24000000000 bytes, 26 are left"},
        {head("element face 1", "element face 4000000000"),
         "is too short: 4000000000 x \"face\" need at least 8000000000 bytes, 9 are left"},
        {head("element vertex 3", "element vertex 4"), "ends in face 0 of 1"},
        {head("3 0 1 2", "3 0 1 3"), "names vertex 3, but has 3 vertices"},
        {head("3 0 1 2", "3 0 1 -1"), "names vertex -1, but has 3 vertices"},
        {head("3 0 1 2", "3 0 1"), "ends in face 0 of 1"},
        {head("3 0 1 2", "-3 0 1 2"), ""},
        {head("1 0 0 0", "1 zero 0 0"), "\"zero\" in vertex 1 is no number"},
        {head("3 0 1 2", "3 0 1.5 2"), "\"1.5\" in face 0 is no number"},
        {head("3 0 1 2", "3 0 1 99999999999999999999"),
         "\"99999999999999999999\" in face 0 is no number"},
        {binary.substr(0, binary.size() - 1),
         "is too short: 3 x \"vertex\" need at least 36 bytes, 35 are left"},
        {binary + '\3' + std::string(11, '\0'), "ends in face 0 of 1"},
        {binary + '\xff' + std::string(11, '\0'), "ends in face 0 of 1"},
        {binary + '\3' + std::string(8, '\0') + "\7" + std::string(3, '\0'),
         "names vertex 7, but has 3 vertices"},
        {zipped.substr(0, zipped.size() / 2), "its gzip data end early"},
        {flipped, "its gzip data are damaged: "},
        {Gzipped(head("element vertex 3", "element vertex 4000000000")),
         "is too short: 4000000000 x \"vertex\" need at least 24000000000 bytes, 67108"},
        {Gzipped(head("element face 1", "element face 4000000000")),
         "is too short: 4000000000 x \"face\" need at least 8000000000 bytes, 67108"},
        {Gzipped(head("element vertex 3", "element vertex 4000000")),
         "ends in vertex 4 of 4000000"},
        {Gzipped(head("element face 1", "element face 4000000")), "ends in face 1 of 4000000"}};
    for (const Damage &d : cases) {
        const auto read = Read(d.bytes);
        if (d.problem.empty()) {
            EXPECT_TRUE(read);  // a face with a negative count is one of the others
            EXPECT_EQ(read->otherFaces, 1u);
            continue;
        }
        EXPECT_FALSE(read) << d.problem;
        EXPECT_EQ(problem.substr(0, d.problem.size()), d.problem);
    }
}

TEST_F(Ply, RandomDamageNeverCrashes) {
    Rng rng(3);
    for (int i = 0; i < 300; ++i) {
        const Layout layout{PlyKind(i % 3), (i & 4) != 0,  (i & 8) != 0, (i & 16) != 0,
                            (i & 32) != 0,  (i & 64) != 0, "u",          "v"};
        std::string bytes = Written(layout, RandomMesh(rng, layout, 20, 30));
        if (i % 5 == 0) bytes = Gzipped(bytes);
        if (rng.Below(2) == 0) bytes.resize(rng.Below(uint32_t(bytes.size())));
        for (uint32_t k = rng.Below(6); k > 0 && !bytes.empty(); --k)
            bytes[rng.Below(uint32_t(bytes.size()))] = char(rng.Below(256));
        const auto read = Read(bytes);
        EXPECT_NE(read.has_value(), !problem.empty());
        if (!read) continue;
        for (const uint32_t index : read->triangles)
            EXPECT_LT(index, read->p.size());
        for (const uint32_t index : read->quads)
            EXPECT_LT(index, read->p.size());
    }
}

TEST_F(Ply, MissingFilesAndFolders) {
    problem.clear();
    EXPECT_FALSE(ReadPly(Path("missing.ply"), &problem));
    EXPECT_EQ(problem, "cannot be opened: No such file or directory");
    EXPECT_FALSE(ReadPly(folder.string(), &problem));
    EXPECT_EQ(problem, "cannot be opened: Is a directory");
    EXPECT_FALSE(ReadPly("/dev/zero", &problem));
    EXPECT_EQ(problem, "cannot be opened: it is a device; expected a file");
    ASSERT_EQ(mkfifo(Path("pipe.ply").c_str(), 0600), 0);
    EXPECT_FALSE(ReadPly(Path("pipe.ply"), &problem));
    EXPECT_EQ(problem, "cannot be opened: it is a pipe; expected a file");
}

TEST_F(Ply, FaceIndicesAreInts) {
    const auto withIndex = [&](const char *type, const std::string &index) {
        return Read(std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                "property float y\nproperty float z\nelement face 1\n"
                                "property list uchar int vertex_indices\nproperty ") +
                    type + " face_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2 " + index + "\n");
    };
    for (const char *good : {"-2147483648", "2147483647", "0"}) {
        const auto read = withIndex("double", good);
        ASSERT_TRUE(read) << problem;
        EXPECT_EQ(read->triangleFaces, std::vector<int>{std::atoi(good)});
    }
    for (const char *bad : {"1e300", "-1e300", "nan", "inf", "2147483648", "0.5"}) {
        EXPECT_FALSE(withIndex("double", bad)) << bad;
        EXPECT_NE(problem.find("face_indices of face 0 is "), std::string::npos) << problem;
    }
    EXPECT_FALSE(withIndex("uint", "4294967295"));
}

TEST_F(Ply, BombsAreRefused) {
    // One list of 80 MB of zeros, packed 1000 times: beyond 64 MiB and 200 times.
    constexpr uint32_t kBlock = 1'000'000, kBlocks = 80;
    std::string head =
        "ply\nformat binary_little_endian 1.0\nelement junk 1\nproperty list uint uchar a\n"
        "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 0\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 4; ++i)
        head += char(kBlock * kBlocks >> 8 * i);
    std::string file = Gzipped(head);
    const std::string block = Gzipped(std::string(kBlock, '\0'));
    for (uint32_t i = 0; i < kBlocks; ++i)
        file += block;
    EXPECT_FALSE(Read(file + Gzipped(std::string(12, '\0'))));
    EXPECT_NE(problem.find("unpacks to more than 67 MB and 200 times its size"), std::string::npos)
        << problem;
}

TEST_F(Ply, MeshesMakeOneShapeForEachKindOfFace) {
    Put("mixed.ply",
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "element face 3\nproperty list uchar int vertex_indices\nproperty int face_indices\n"
        "end_header\n0 0 0 0 0 1  1 0 0 0 0 1  1 1 0 0 0 1  0 1 0 0 0 1  2 2 0 0 0 1\n"
        "4 0 1 2 3 40\n3 1 4 2 30\n6 0 1 2 3 4 0 50\n");
    const Made made = Make("Translate 0 0 5 Shape \"plymesh\" \"string filename\" \"mixed.ply\"",
                           folder.string());
    ASSERT_EQ(made.shapes.size(), 2u);
    const auto &quads = std::get<BilinearMesh>(made.shapes[0]);
    EXPECT_EQ(quads.indices, (std::vector<uint32_t>{0, 1, 3, 2}));
    EXPECT_EQ(quads.faceIndices, std::vector<int>{40});
    EXPECT_TRUE(quads.planar);
    const auto &triangles = std::get<TriangleMesh>(made.shapes[1]);
    EXPECT_EQ(triangles.indices, (std::vector<uint32_t>{1, 4, 2}));
    EXPECT_EQ(triangles.faceIndices, std::vector<int>{30});
    EXPECT_EQ(triangles.p[4], (Point3f{2, 2, 5}));
    ASSERT_EQ(made.messages.size(), 1u);
    EXPECT_EQ(made.messages[0], "test.pbrt:2:33: " + Path("mixed.ply") +
                                    ": 1 faces have other than 3 or 4 corners and are left out");
}

TEST_F(Ply, NormalsThatAreNoNumbersAreNone) {
    PlyWriter w(PlyKind::Little);
    w.Line("element vertex 4");
    for (const char *const name : {"x", "y", "z", "nx", "ny", "nz"})
        w.Line(std::string("property float ") + name);
    w.Line("element face 2\nproperty list uchar int vertex_indices\nend_header");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float vertices[4][6] = {{0, 0, 0, 0, 0.6f, 0.8f},
                                  {1, 0, 0, nan, nan, nan},
                                  {1, 1, 0, nan, nan, nan},
                                  {0, 1, 0, nan, 0, 0}};
    for (const auto &vertex : vertices)
        for (const float value : vertex)
            w.Put(value);
    for (const int face : {0, 1}) {
        w.Put(uint8_t(3));
        for (const int corner : {0, 1, 2})
            w.Put(int32_t(face + corner));
    }
    Put("nan.ply", w.Text());
    const Made made = Make("Shape \"plymesh\" \"string filename\" \"nan.ply\"", folder.string());
    ASSERT_EQ(made.shapes.size(), 1u);
    ASSERT_EQ(made.messages.size(), 1u);
    EXPECT_EQ(made.messages[0], "test.pbrt:2:17: " + Path("nan.ply") +
                                    ": 3 of 4 normals are not finite, the first is that of vertex "
                                    "1; these vertices have none");
    // The one good normal counts alone; where there is none the face's does.
    const auto shadingNormal = [&](uint32_t triangle) {
        Hit hit;
        hit.primitive = triangle;
        hit.u = hit.v = 1 / 3.f;
        return SurfaceAt(made.shapes[0], hit, Ray{{0.5f, 0.5f, 1}, {0, 0, -1}, Infinity, 0}).ns;
    };
    EXPECT_LT(Length(shadingNormal(0) - Normal3f{0, 0.6f, 0.8f}), 1e-6f);
    EXPECT_LT(Length(shadingNormal(1) - Normal3f{0, 0, 1}), 1e-6f);
}

TEST_F(Ply, ErrorsNameTheFile) {
    const auto said = [&](const std::string &bytes) {
        Put("bad.ply", bytes);
        const Made made =
            Make("Shape \"plymesh\" \"string filename\" \"bad.ply\"", folder.string());
        EXPECT_TRUE(made.shapes.empty());
        return made.messages.at(0);
    };
    const std::string start = "test.pbrt:2:17: " + Path("bad.ply") + ": ";
    EXPECT_EQ(said("junk"), start + "is no PLY file: it does not start with \"ply\"");
    EXPECT_EQ(said(kTriangleHead + "0 0 0 1 0 0 nan 1 0\n3 0 1 2\n"),
              start + "point 2 is not finite: (nan, 1, 0) placed at (nan, nan, nan)");
    EXPECT_EQ(said(Replaced(kTriangleHead, "face 1", "face 0") + "0 0 0 1 0 0 0 1 0\n"),
              start + "has no face of 3 or 4 corners");
}

}  // namespace
}  // namespace pbrt
