#include <gtest/gtest.h>

#include <cstring>

#include "pbrt/cyhair2pbrt/command.h"
#include "pbrt/cyhair2pbrt/hair_file.h"
#include "pbrt/scene/description.h"
#include "pbrt/util/atomic_file.h"
#include "support/temp_folder.h"

namespace pbrt::cyhair2pbrt {
namespace {

template <typename T>
void Put(std::string *bytes, T value) {
    bytes->append(reinterpret_cast<const char *>(&value), sizeof(T));
}

/// Strands of these numbers of segments along z, at x = 0, 1, 2 ...
std::string Hair(const std::vector<uint16_t> &segments, bool thickness) {
    uint32_t points = 0;
    for (const uint16_t n : segments)
        points += n + 1u;
    std::string bytes = "HAIR";
    Put(&bytes, uint32_t(segments.size()));
    Put(&bytes, points);
    Put(&bytes, uint32_t(thickness ? 7 : 3));
    Put(&bytes, uint32_t(0));
    Put(&bytes, 0.25f);
    bytes.resize(128);
    for (const uint16_t n : segments)
        Put(&bytes, n);
    for (size_t s = 0; s < segments.size(); ++s)
        for (int i = 0; i <= segments[s]; ++i)
            for (const float v : {float(s), 0.f, float(i)})
                Put(&bytes, v);
    for (uint32_t i = 0; thickness && i < points; ++i)
        Put(&bytes, float(i + 1));
    return bytes;
}

std::string Text(const std::string &bytes, int maxStrands, float width) {
    const OrError<HairFile> hair = ParseHair(bytes);
    EXPECT_TRUE(hair) << hair.error;
    return CurvesOf(*hair.value, maxStrands, width);
}

TEST(Hair, StrandsBecomeCurvesWithYUp) {
    const std::string text = Text(Hair({1, 2}, false), -1, 0.5f);
    EXPECT_EQ(text.substr(0, text.find('\n')), "# 2 of 2 strands within (0, 0, 0) and (1, 2, 0)");
    SceneDescription scene;
    Diagnostics log;
    ParseString("WorldBegin\n" + text, "hair.pbrt", "", scene, log);
    EXPECT_FALSE(log.HasErrors());
    ASSERT_EQ(scene.shapes.size(), 2u);
    size_t points = 4;
    for (const ShapeEntity &curve : scene.shapes) {
        EXPECT_EQ(curve.type, "curve");
        for (const ParsedParameter &p : curve.params) {
            if (p.name != "P") continue;
            ASSERT_EQ(p.floats.size(), 3 * points);
            for (size_t i = 0; i < points; ++i)  // straight and even: every third of a unit
                EXPECT_NEAR(p.floats[3 * i + 1], float(i) / 3, 1e-6f);
        }
        points += 3;
    }
}

TEST(Hair, WidthsAreGivenOrTheFiles) {
    EXPECT_NE(Text(Hair({1}, true), -1, 0.5f).find("\"float width0\" 0.5 \"float width1\" 0.5"),
              std::string::npos);
    EXPECT_NE(Text(Hair({1}, true), -1, -1).find("\"float width0\" 1 \"float width1\" 2"),
              std::string::npos);
    EXPECT_NE(Text(Hair({1}, false), -1, -1).find("\"float width0\" 0.25"), std::string::npos);
}

TEST(Hair, OnlyTheFirstStrandsAndNoSinglePoints) {
    EXPECT_TRUE(Text(Hair({0, 1, 1}, false), 1, 1).starts_with("# 1 of 3 strands"));
    EXPECT_EQ(Text(Hair({0}, false), -1, 1), "# 0 of 1 strands\n");
}

TEST(Hair, CutAndFalseFilesAreRefused) {
    const std::string whole = Hair({3, 2}, true);
    for (size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(ParseHair(std::string_view(whole).substr(0, size))) << size;
    EXPECT_TRUE(ParseHair(whole));
    std::string many = whole;
    const uint32_t huge = 0xfffffff0;
    std::memcpy(&many[8], &huge, 4);
    EXPECT_EQ(ParseHair(many).error, "has 4294967280 points, where its strands need 7");
    std::memcpy(&many[4], &huge, 4);
    EXPECT_FALSE(ParseHair(many)) << "no memory is taken for what is not there";
}

class HairCommand : public TempFolder {};

TEST_F(HairCommand, WritesAFileOrPrints) {
    EXPECT_EQ(WriteFileAtomically(Path("a.hair"), Hair({1, 1}, true)), std::nullopt);
    const std::vector<std::string> print{Path("a.hair"), "-", "1", "-1"};
    const cli::Outcome printed = cyhair2pbrt::Run(print);
    EXPECT_EQ(printed.exitCode, 0) << printed.err;
    EXPECT_EQ(printed.out, Text(Hair({1, 1}, true), 1, -1));
    const std::vector<std::string> write{Path("a.hair"), Path("a.pbrt")};
    EXPECT_EQ(cyhair2pbrt::Run(write).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(Path("a.pbrt")));
    const std::vector<std::string> none{Path("b.hair"), "-"};
    EXPECT_EQ(cyhair2pbrt::Run(none).exitCode, 1);
}

}  // namespace
}  // namespace pbrt::cyhair2pbrt
