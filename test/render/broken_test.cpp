// Mistakes that only plug-ins can see: every scene of broken/ says exactly what is expected.

#include "pbrt/materials/materials.h"
#include "pbrt/render/render.h"
#include "support/corpus.h"

namespace pbrt {
namespace {

constexpr char kFolder[] = "render/broken";

/// So that a new plug-in changes no expected message.
Placeholders AllNames() {
    return {{"{all materials}", QuotedList(MaterialNames())},
            {"{all samplers}", QuotedList(SamplerTypes::kNames)},
            {"{all filters}", QuotedList(FilterTypes::kNames)},
            {"{all cameras}", QuotedList(CameraTypes::kNames)}};
}

class BrokenPlugin : public testing::TestWithParam<std::string> {};

TEST_P(BrokenPlugin, SaysWhatIsExpected) {
    const auto build = [](const std::string &file, Diagnostics &log) {
        SceneDescription scene;
        ParseFiles({file}, scene, log);
        EXPECT_FALSE(MakeRenderTask(std::move(scene), {}, log));
    };
    ExpectMessages(kFolder, GetParam(), build, AllNames());
}

INSTANTIATE_TEST_SUITE_P(Corpus, BrokenPlugin, testing::ValuesIn(CorpusScenes(kFolder)),
                         CorpusTestName);

}  // namespace
}  // namespace pbrt
