// Mistakes that only plug-ins can see: every scene of broken/ says exactly what is expected.

#include "pbrt/render/render.h"
#include "support/corpus.h"

namespace pbrt {
namespace {

constexpr char kFolder[] = "render/broken";

class BrokenPlugin : public testing::TestWithParam<std::string> {};

TEST_P(BrokenPlugin, SaysWhatIsExpected) {
    ExpectMessages(kFolder, GetParam(), [](const std::string &file, Diagnostics &log) {
        SceneDescription scene;
        ParseFiles({file}, scene, log);
        EXPECT_FALSE(MakeRenderTask(scene, {}, log));
    });
}

INSTANTIATE_TEST_SUITE_P(Corpus, BrokenPlugin, testing::ValuesIn(CorpusScenes(kFolder)),
                         CorpusTestName);

}  // namespace
}  // namespace pbrt
