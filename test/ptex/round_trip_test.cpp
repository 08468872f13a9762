#include <cstring>

#include "pbrt/util/read_file.h"
#include "ptex/samples.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

class PtexRoundTrip : public TempFolder {
  protected:
    PtexTexture WriteAndRead(const PtexContent &content) const {
        EXPECT_EQ(WritePtex(Path("a.ptx"), content), std::nullopt);
        return ReadPtexOrFail(Path("a.ptx"));
    }
    static void ExpectSame(const PtexContent &a, const PtexContent &b) {
        EXPECT_EQ(a.mesh, b.mesh);
        EXPECT_EQ(a.type, b.type);
        EXPECT_EQ(a.nChannels, b.nChannels);
        EXPECT_EQ(a.alphaChannel, b.alphaChannel);
        EXPECT_EQ(a.metadata, b.metadata);
        ASSERT_EQ(a.faces.size(), b.faces.size());
        for (size_t f = 0; f < a.faces.size(); ++f) {
            EXPECT_EQ(a.faces[f].log2U, b.faces[f].log2U);
            EXPECT_EQ(a.faces[f].log2V, b.faces[f].log2V);
            EXPECT_EQ(a.faces[f].neighbours, b.faces[f].neighbours);
            EXPECT_EQ(a.faces[f].neighbourEdges, b.faces[f].neighbourEdges);
        }
        EXPECT_EQ(a.texels, b.texels);
    }
};

constexpr std::array kTypes{PtexType::UInt8, PtexType::UInt16, PtexType::Half, PtexType::Float};

TEST_F(PtexRoundTrip, KeepsEverything) {
    // Single texels, strips, both sides of the size at which faces are tiled.
    const std::vector<PtexFace> faces{{0, 0, {1, -1, 2, -1}, {3, 0, 1, 0}}, {0, 5}, {6, 0}, {3, 4},
                                      {8, 9, {-1, 0, 3, -1}, {0, 2, 1, 3}}, {2, 2}};
    for (const PtexType type : kTypes)
        for (const int nChannels : {1, 3, 4}) {
            SCOPED_TRACE(testing::Message() << int(type) << " " << nChannels);
            PtexContent content = RandomPtex(PtexMesh::Quad, type, nChannels, faces, 1);
            content.alphaChannel = nChannels == 4 ? 3 : -1;
            content.metadata = {{"made", "here"}, {"empty", ""}};
            ExpectSame(WriteAndRead(content).Content(), content);
        }
}

TEST_F(PtexRoundTrip, KeepsTriangles) {
    const std::vector<PtexFace> faces{
        {4, 4, {1, -1, -1, -1}, {2, 0, 0, 0}}, {2, 2, {-1, -1, 0, -1}, {0, 0, 0, 0}}, {0, 0}};
    for (const PtexType type : kTypes) {
        const PtexContent content = RandomPtex(PtexMesh::Triangle, type, 3, faces, 2);
        ExpectSame(WriteAndRead(content).Content(), content);
    }
}

TEST_F(PtexRoundTrip, KeepsConstantFacesAndTiles) {
    PtexContent content = RandomPtex(PtexMesh::Quad, PtexType::Float, 2, {{9, 8}, {3, 3}}, 3);
    for (size_t i = 0; i < content.texels.size(); ++i)
        if (i / 2 / 512 < 200 || i / 2 >= 512 * 256) content.texels[i] = float(i % 2) + 0.5f;
    const PtexTexture texture = WriteAndRead(content);
    ExpectSame(texture.Content(), content);
    EXPECT_EQ(texture.NLevels(1), 1);
}

TEST_F(PtexRoundTrip, KeepsStoredReductions) {
    // The file's reductions are those made in memory, bit by bit; the coarser ones are made again.
    const PtexContent content =
        RandomPtex(PtexMesh::Quad, PtexType::UInt16, 3, {{3, 7}, {5, 4}, {9, 8}, {2, 2}}, 4);
    const PtexTexture inMemory(PackPtex(content)), read = WriteAndRead(content);
    ASSERT_EQ(inMemory.Texels().BytesNeeded(), read.Texels().BytesNeeded());
    for (int f = 0; f < read.NFaces(); ++f)
        for (int level = 0; level < read.NLevels(f); ++level)
            EXPECT_EQ(std::memcmp(read.Texels().Level(f, level), inMemory.Texels().Level(f, level),
                                  read.Texels().LevelBytes(f, level)),
                      0)
                << f << " " << level;
}

TEST_F(PtexRoundTrip, ManyConstantFaces) {
    std::vector<float> values(30000 * 3);
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = float(i) * 0.01f;
    const PtexContent content = ConstantPtex(3, values);
    const PtexTexture texture = WriteAndRead(content);
    EXPECT_EQ(texture.Content().texels, values);
    EXPECT_TRUE(texture.IsFlat());
    // 12 bytes of texel and a record of 16.
    EXPECT_LE(texture.MemoryBytes(), 30000u * 40);
    EXPECT_EQ(LookupAll(texture, 7, {0.2f, 0.9f}),
              (std::vector<float>{values[21], values[22], values[23]}));
}

TEST_F(PtexRoundTrip, OutOfRangeValuesAreClamped) {
    PtexContent content = ConstantPtex(1, {-1, 2, 0.5f});
    content.type = PtexType::UInt8;
    EXPECT_EQ(WriteAndRead(content).Content().texels, (std::vector<float>{0, 1, 128 / 255.f}));
    content.texels = {1e6f, -1e6f, 1};
    content.type = PtexType::Half;
    EXPECT_EQ(WriteAndRead(content).Content().texels, (std::vector<float>{65504, -65504, 1}));
}

TEST_F(PtexRoundTrip, SameContentSameBytes) {
    const PtexContent content = RandomPtex(PtexMesh::Quad, PtexType::Half, 3, {{5, 5}, {3, 2}}, 5);
    EXPECT_EQ(WritePtex(Path("a.ptx"), content), std::nullopt);
    EXPECT_EQ(WritePtex(Path("b.ptx"), content), std::nullopt);
    EXPECT_EQ(*ReadWholeFile(Path("a.ptx")).bytes, *ReadWholeFile(Path("b.ptx")).bytes);
}

TEST_F(PtexRoundTrip, RefusesContradictions) {
    const PtexContent good = ConstantPtex(1, {0, 1});
    const auto refused = [&](const char *part, auto change) {
        PtexContent bad = good;
        change(bad);
        const std::optional<std::string> why = WritePtex(Path("bad.ptx"), bad);
        ASSERT_TRUE(why) << part;
        EXPECT_TRUE(why->starts_with(Path("bad.ptx") + ": ")) << *why;
        EXPECT_NE(why->find(part), std::string::npos) << *why;
    };
    refused("are given", [](PtexContent &c) { c.texels.pop_back(); });
    refused("not finite", [](PtexContent &c) { c.texels[1] = NAN; });
    refused("channels", [](PtexContent &c) { c.nChannels = 0; });
    refused("alpha", [](PtexContent &c) { c.alphaChannel = 1; });
    refused("faces", [](PtexContent &c) { c = ConstantPtex(1, {}); });
    refused("face 1: neighbour 2", [](PtexContent &c) { c.faces[1].neighbours[3] = 2; });
    refused("face 0: edge 4", [](PtexContent &c) { c.faces[0].neighbourEdges[0] = 4; });
    refused("face 0: resolution", [](PtexContent &c) { c.faces[0].log2U = 16; });
    refused("triangle", [](PtexContent &c) {
        c.mesh = PtexMesh::Triangle;
        c.faces[0].log2U = 1;
    });
    refused("more than", [](PtexContent &c) { c.faces[0].log2U = c.faces[0].log2V = 15; });
    refused("key", [](PtexContent &c) { c.metadata[""] = "x"; });
    EXPECT_EQ(FileCount(), 0u);
    EXPECT_TRUE(WritePtex(Path("no/such/folder.ptx"), good));
}

}  // namespace
}  // namespace pbrt
