// Integrators of pbrt-v4 that `path` stands in for, and the accelerators' names.

#include <fmt/format.h>

#include "pbrt/integrators/stand_ins.h"
#include "render/render_text.h"

namespace pbrt::test {
namespace {

struct Made {
    std::optional<RenderTask> task;
    std::vector<std::string> messages;
};
Made MakeOf(const std::string &directive) {
    Diagnostics log;
    SceneDescription description;
    ParseString(directive + "\nWorldBegin LightSource \"infinite\" Shape \"sphere\"", "test.pbrt",
                "", description, log);
    Made made{MakeRenderTask(std::move(description), {}, log), {}};
    for (const Message &m : log.Messages())
        made.messages.push_back(m.text);
    return made;
}

TEST(StandIns, ArePathWithOneWarningAtTheirLine) {
    for (const std::string_view name : StandInNames()) {
        const Made made = MakeOf(fmt::format("Integrator \"{}\" \"integer maxdepth\" 3", name));
        ASSERT_TRUE(made.task) << name;
        const auto *const path = std::get_if<PathIntegrator>(&made.task->integrator);
        ASSERT_TRUE(path) << name;
        EXPECT_EQ(path->maxDepth, 3);
        ASSERT_EQ(made.messages.size(), 1u) << name;
        EXPECT_EQ(made.messages[0].find("test.pbrt:1:1: integrator \""), 0u) << made.messages[0];
        EXPECT_NE(made.messages[0].find("\"path\" renders in its place"), std::string::npos);
    }
}

TEST(StandIns, TakeTheirOwnParametersOnly) {
    for (const char *const right :
         {"\"bdpt\" \"bool visualizestrategies\" true \"bool visualizeweights\" true \"bool "
          "regularize\" true",
          "\"mlt\" \"integer bootstrapsamples\" 1 \"integer chains\" 2 \"integer "
          "mutationsperpixel\" 3 \"float largestepprobability\" .1 \"float sigma\" .2 \"bool "
          "regularize\" false",
          "\"sppm\" \"integer photonsperiteration\" 100 \"float radius\" .01 \"integer seed\" 4",
          "\"lightpath\"", "\"simplevolpath\""})
        EXPECT_EQ(MakeOf(std::string("Integrator ") + right).messages.size(), 1u) << right;
    EXPECT_FALSE(MakeOf("Integrator \"bdpt\" \"float radius\" 1").task);
    EXPECT_FALSE(MakeOf("Integrator \"sppm\" \"bool regularize\" true").task);
}

TEST(StandIns, ExhaustiveLightSamplingIsByTheTree) {
    const Made made = MakeOf("Integrator \"path\" \"string lightsampler\" \"exhaustive\"");
    ASSERT_TRUE(made.task);
    EXPECT_EQ(std::get_if<PathIntegrator>(&made.task->integrator)->lightSamplerName, "bvh");
    ASSERT_EQ(made.messages.size(), 1u);
    EXPECT_EQ(made.messages[0].find("test.pbrt:1:19: "), 0u) << made.messages[0];
}

TEST(Accelerators, AreAcceptedByName) {
    for (const char *const right :
         {"\"bvh\" \"string splitmethod\" \"hlbvh\" \"integer maxnodeprims\" 1",
          "\"kdtree\" \"integer intersectcost\" 80 \"integer traversalcost\" 2 \"float "
          "emptybonus\" .2 \"integer maxprims\" 4 \"integer maxdepth\" 9"}) {
        const Made made = MakeOf(std::string("Accelerator ") + right);
        EXPECT_TRUE(made.task) << right;
        EXPECT_EQ(made.messages.size(), 0u) << right;
    }
    EXPECT_FALSE(MakeOf("Accelerator \"kdtree\" \"integer maxnodeprims\" 1").task);
}

}  // namespace
}  // namespace pbrt::test
