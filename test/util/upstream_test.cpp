#include "pbrt/util/upstream.h"

#include <gtest/gtest.h>

#include "pbrt/util/diagnostics.h"

namespace pbrt {
namespace {

TEST(Upstream, IsNamedInMessages) {
    const std::string_view known[] = {"zsobol", "halt"};
    EXPECT_EQ(UnknownName("sampler", "halton", known),
              "unknown sampler \"halton\"; pbrt-v4 has it, not built here; use \"zsobol\". Known: "
              "\"zsobol\" or \"halt\"");
    EXPECT_EQ(UnknownName("sampler", "halten", known),
              "unknown sampler \"halten\"; did you mean \"halt\"? Known: \"zsobol\" or \"halt\"");
    EXPECT_EQ(PbrtHasIt("light", "halton"), "");
}

TEST(Upstream, EveryNameStandsOnce) {
    for (const UpstreamName &a : NotBuiltHere())
        for (const UpstreamName &b : NotBuiltHere())
            EXPECT_TRUE(&a == &b || a.kind != b.kind || a.name != b.name) << a.name;
}

}  // namespace
}  // namespace pbrt
