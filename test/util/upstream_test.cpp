#include "pbrt/util/upstream.h"

#include <gtest/gtest.h>

#include "pbrt/util/diagnostics.h"

namespace pbrt {
namespace {

TEST(Upstream, IsNamedInMessages) {
    const std::string_view known[] = {"path", "sppn"};
    EXPECT_EQ(UnknownName("integrator", "sppm", known),
              "unknown integrator \"sppm\"; pbrt-v4 has it, not built here; use \"path\". Known: "
              "\"path\" or \"sppn\"");
    EXPECT_EQ(UnknownName("integrator", "spbn", known),
              "unknown integrator \"spbn\"; did you mean \"sppn\"? Known: \"path\" or \"sppn\"");
    EXPECT_EQ(PbrtHasIt("light", "sppm"), "");
}

TEST(Upstream, EveryNameStandsOnce) {
    for (const UpstreamName &a : NotBuiltHere())
        for (const UpstreamName &b : NotBuiltHere())
            EXPECT_TRUE(&a == &b || a.kind != b.kind || a.name != b.name) << a.name;
}

}  // namespace
}  // namespace pbrt
