// $frame and expressions of it in scene text and names.

#include "pbrt/scene/frame_text.h"

#include <gtest/gtest.h>

namespace pbrt {
namespace {

std::string At(const std::string &text, int frame) {
    const OrError<std::string> put = PutFrame(text, frame);
    EXPECT_TRUE(put) << put.error;
    return put.value.value_or("");
}

TEST(FrameText, IsANumber) {
    EXPECT_EQ(At("Rotate $frame 0 1 0", 7), "Rotate 7 0 1 0");
    EXPECT_EQ(At("\"f-$frame.ply\" $framerate", -2), "\"f--2.ply\" -2rate");
    EXPECT_EQ(At("costs 5$ ($5)", 1), "costs 5$ ($5)");
}

TEST(FrameText, IsALinearExpression) {
    EXPECT_EQ(At("$(7.5 * (frame - 1))", 3), "15");
    EXPECT_EQ(At("$(frame / 4)", 3), "0.75");
    EXPECT_EQ(At("$(-frame+2e1)", 3), "17");
    EXPECT_EQ(At("$((frame - 1) * 2 / (3 - 1) - -1)", 3), "3");
    EXPECT_EQ(At("[$(frame)$(2)]", 3), "[32]");
}

TEST(FrameText, CommentsStayButNotInQuotes) {
    EXPECT_EQ(At("a # $frame $(\n$frame", 4), "a # $frame $(\n4");
    EXPECT_EQ(At("\"a#$frame\" \"b\\\"#$frame\"", 4), "\"a#4\" \"b\\\"#4\"");
    EXPECT_EQ(*PutFrameInName("a#$frame", 4).value, "a#4");
}

TEST(FrameText, NamesWithAFrameAreKnown) {
    EXPECT_TRUE(NamesFrame("a-$frame.exr"));
    EXPECT_TRUE(NamesFrame("$(2*frame)"));
    EXPECT_FALSE(NamesFrame("a.exr"));
    EXPECT_FALSE(NamesFrame("$(5)"));
}

TEST(FrameText, MistakesHaveALine) {
    EXPECT_EQ(PutFrame("\n\n$(1/frame)", 1).error, "line 3: $(1/frame): it is not linear in frame");
}

}  // namespace
}  // namespace pbrt
