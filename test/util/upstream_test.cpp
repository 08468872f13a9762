#include "pbrt/util/upstream.h"

#include <gtest/gtest.h>

#include "pbrt/util/diagnostics.h"

namespace pbrt {
namespace {

TEST(Upstream, IsNamedInMessages) {
    const std::string_view known[] = {"conductor", "measure"};
    EXPECT_EQ(UnknownName("material", "measured", known),
              "material \"measured\": pbrt-v4 has it; not built here. Use \"conductor\" or "
              "\"coateddiffuse\" with a color like it");
    EXPECT_EQ(UnknownName("material", "measurer", known),
              "unknown material \"measurer\"; did you mean \"measure\"? Known: \"conductor\" or "
              "\"measure\"");
    EXPECT_EQ(PbrtHasIt("light", "measured"), "");
}

TEST(Upstream, OldNamesAreToldTheNewOnes) {
    const std::string_view known[] = {"diffuse"};
    EXPECT_EQ(UnknownName("material", "matte", known),
              "unknown material \"matte\"; pbrt-v4 calls it \"diffuse\"");
    EXPECT_EQ(UnknownName("material", "fourier", known),
              "unknown material \"fourier\"; pbrt-v4 calls it \"measured\", which is not built "
              "here");
    ASSERT_TRUE(FindOldName("film", "image"));
    EXPECT_EQ(FindOldName("film", "image")->is, "rgb");
    EXPECT_FALSE(FindOldName("film", "matte"));
}

TEST(Upstream, EveryNameStandsOnce) {
    for (const UpstreamName &a : NotBuiltHere())
        for (const UpstreamName &b : NotBuiltHere())
            EXPECT_TRUE(&a == &b || a.kind != b.kind || a.name != b.name) << a.name;
}

}  // namespace
}  // namespace pbrt
