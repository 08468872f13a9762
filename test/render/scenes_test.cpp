// Every scene of scenes/ that has a reference picture still renders it, within noise.

#include <cstdlib>
#include <filesystem>

#include "pbrt/build/build_scene.h"
#include "pbrt/imgtool/tile_scores.h"
#include "pbrt/render/render.h"
#include "render/render_text.h"
#include "support/folders.h"

namespace pbrt::test {
namespace {

namespace fs = std::filesystem;

/// As in scripts/reference.sh, with a seed of its own: then the variances' ratio is exact also for
/// samplers that converge faster than 1/n.
constexpr int kSpp = 16, kSeed = 100000;

std::vector<std::string> ScenesWithReference() {
    std::vector<std::string> names;
    for (const fs::directory_entry &folder : fs::directory_iterator(SourceDir() + "/scenes"))
        if (fs::exists(folder.path() / "reference.exr"))
            names.push_back(folder.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

class Scenes : public testing::TestWithParam<std::string> {};

TEST_P(Scenes, LookLikeTheirReference) {
    const std::string folder = SourceDir() + "/scenes/" + GetParam() + "/";
    if (fs::exists(folder + "generate.sh")) {
        ASSERT_EQ(
            std::system(("'" + folder + "generate.sh' '" + ProgramDir() + "' >/dev/null").c_str()),
            0);
    }
    const Image reference = *ReadImage(folder + "reference.exr").value;
    const Image variance = *ReadImage(folder + "reference-variance.exr").value;
    Diagnostics log;
    SceneDescription description;
    description.options.seed = kSeed;
    ParseFiles({folder + GetParam() + ".pbrt"}, description, log);
    Overrides overrides;
    overrides.spp = kSpp;
    overrides.film.quick = true;
    const std::optional<RenderTask> task = MakeRenderTask(std::move(description), overrides, log);
    for (const Message &m : log.Messages())
        ADD_FAILURE() << m.text;
    ASSERT_TRUE(task);
    const Image image = test::RenderAll(*task).image;
    ASSERT_EQ(image.Resolution(), reference.Resolution());
    const double runs = double(*reference.metadata.samplesPerPixel) / kSpp;
    const imgtool::TileScores z =
        imgtool::CompareTiles(image, reference, variance, runs, 10, 0.001);
    EXPECT_EQ(z.beyond, 0) << "worst z " << z.worstZ << " (bound " << z.bound << ") at pixel "
                           << z.worstTile.x << ", " << z.worstTile.y;
    // Tiles' channels are correlated: as if a third of the scores were independent.
    EXPECT_LT(std::abs(z.meanZ), 4 / std::sqrt(z.scores / 3.0));
    EXPECT_LT(z.rmsZ, 1.3);
    EXPECT_GT(z.rmsZ, 0.7);
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(ScenesWithReference()),
                         [](const auto &name) {
                             std::string text = name.param;
                             std::replace(text.begin(), text.end(), '-', '_');
                             return text;
                         });

}  // namespace
}  // namespace pbrt::test
