#include "ptex/samples.h"

namespace pbrt {
namespace {

TEST(PtexRead, AgreesWithTheRealLibrary) {
    const std::vector<PtexSample> samples = ExpectedSamples();
    ASSERT_EQ(samples.size(), 9u);
    float worstTexel = 0, worstLookup = 0;
    int nTexels = 0, nLookups = 0;
    for (const PtexSample &sample : samples) {
        SCOPED_TRACE(sample.file);
        const PtexTexture texture = ReadPtexOrFail(kPtexData + sample.file);
        EXPECT_EQ(texture.Mesh() == PtexMesh::Quad, sample.mesh == "quad");
        constexpr std::array<const char *, 4> kTypes{"uint8", "uint16", "float16", "float32"};
        EXPECT_EQ(kTypes[size_t(texture.Type())], sample.type);
        ASSERT_EQ(texture.NChannels(), sample.nChannels);
        ASSERT_EQ(texture.NFaces(), sample.nFaces);
        EXPECT_EQ(texture.Metadata().at("made"), "sample");
        for (const PtexProbe &p : sample.texels)
            for (int c = 0; c < sample.nChannels; ++c, ++nTexels)
                worstTexel = std::max(worstTexel,
                                      std::abs(texture.Texel(p.face, 0, {int(p.x), int(p.y)}, c) -
                                               p.channels[size_t(c)]));
        for (const PtexProbe &p : sample.lookups) {
            const std::vector<float> got = LookupAll(texture, p.face, {p.x, p.y});
            for (int c = 0; c < sample.nChannels; ++c, ++nLookups)
                worstLookup =
                    std::max(worstLookup, std::abs(got[size_t(c)] - p.channels[size_t(c)]));
        }
    }
    EXPECT_GT(nTexels, 500);
    EXPECT_GT(nLookups, 400);
    // Printed with 9 digits; 1/255 has half an ulp.
    EXPECT_LE(worstTexel, 1.2e-7f);
    // Four products and sums of numbers below 1; the triangles' kernel sums some 30.
    EXPECT_LE(worstLookup, 1e-6f);
    RecordProperty("worstTexel", std::to_string(worstTexel));
    RecordProperty("worstLookup", std::to_string(worstLookup));
}

TEST(PtexRead, ReductionsAreMeans) {
    // The library truncates whole numbers: up to 1 below the mean. Half: one of its ulps.
    const std::vector<std::pair<std::string, float>> files{
        {"quad_u8.ptx", 1 / 255.f}, {"quad_u16.ptx", 1 / 65535.f}, {"quad_half.ptx", 5e-4f},
        {"quad_float.ptx", 1e-6f},  {"tiled_u8.ptx", 1 / 255.f},   {"tiled_half.ptx", 5e-4f}};
    for (const auto &[file, tolerance] : files) {
        SCOPED_TRACE(file);
        const PtexTexture t = ReadPtexOrFail(kPtexData + file);
        for (int face = 0; face < t.NFaces(); ++face)
            for (int level = 1; level < t.NLevels(face); ++level) {
                const int nU = std::max(1 << t.Texels().Log2U(face) >> level, 1);
                const int nV = std::max(1 << t.Texels().Log2V(face) >> level, 1);
                const int dx = t.Texels().Log2U(face) >= level,
                          dy = t.Texels().Log2V(face) >= level;
                float worst = 0;
                for (int y = 0; y < nV; ++y)
                    for (int x = 0; x < nU; ++x) {
                        float sum = 0;
                        for (const Point2i d : {Point2i{0, 0}, {dx, 0}, {0, dy}, {dx, dy}})
                            sum += t.Texel(face, level - 1, {(x << dx) + d.x, (y << dy) + d.y}, 0);
                        worst =
                            std::max(worst, std::abs(sum / 4 - t.Texel(face, level, {x, y}, 0)));
                    }
                EXPECT_LE(worst, tolerance * 1.001f) << face << " on level " << level;
            }
    }
}

TEST(PtexRead, AMissingFileIsAnError) {
    const OrError<PtexData> data = ReadPtex("/nowhere/a.ptx");
    ASSERT_FALSE(data);
    EXPECT_TRUE(data.error.starts_with("/nowhere/a.ptx: ")) << data.error;
}

}  // namespace
}  // namespace pbrt
