// Every scene of broken/ says exactly what its .expected file holds.

#include "support/corpus.h"

#include "pbrt/scene/description.h"

namespace pbrt {
namespace {

constexpr char kFolder[] = "scene/broken";

class BrokenScene : public testing::TestWithParam<std::string> {};

TEST_P(BrokenScene, SaysWhatIsExpected) {
    ExpectMessages(kFolder, GetParam(), [](const std::string &file, Diagnostics &log) {
        SceneDescription scene;
        ParseFiles({file}, scene, log);
    });
}

INSTANTIATE_TEST_SUITE_P(Corpus, BrokenScene, testing::ValuesIn(CorpusScenes(kFolder)),
                         CorpusTestName);

}  // namespace
}  // namespace pbrt
