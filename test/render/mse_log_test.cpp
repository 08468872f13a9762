// Pictures rendered in waves, and their error as it falls.

#include "pbrt/render/mse_log.h"

#include <sstream>

#include "pbrt/imgtool/metric.h"
#include "pbrt/util/read_file.h"
#include "render/render_text.h"
#include "support/temp_folder.h"

namespace pbrt::test {
namespace {

constexpr char kScene[] =
    "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 32 \"string filename\" "
    "\"out.exr\"\nSampler \"independent\" \"integer pixelsamples\" 72\nIntegrator \"path\" "
    "\"integer maxdepth\" 1\nWorldBegin\nLightSource \"point\" \"point3 from\" [ 0 0 0 ]\n"
    "Material \"diffuse\"\nShape \"bilinearmesh\" \"point3 P\" [ -9 -9 3  9 -9 3  -9 9 3  9 9 3 ]\n"
    "LightSource \"infinite\"\n";

std::optional<RenderTask> Build(const std::string &text, Diagnostics &log) {
    SceneDescription description;
    ParseString(text, "test.pbrt", ".", description, log);
    return MakeRenderTask(std::move(description), {}, log);
}

class Passes : public TempFolder {
  protected:
    Options Files() const {
        Options options;
        options.mseReferenceImage = Path("reference.exr");
        options.mseReferenceOut = Path("mse.txt");
        return options;
    }
};

TEST_F(Passes, EndInThePictureThatIsRenderedAtOnce) {
    Diagnostics log;
    const auto task = Build(kScene, log);
    Image passes;
    std::vector<int> counts;
    std::vector<float> means;
    ASSERT_TRUE(Render(*task, 2, GoOn, &passes, [&](int samples) {
        counts.push_back(samples);
        means.push_back(float(Mean(passes)[1]));
    }));
    EXPECT_EQ(counts, (std::vector<int>{1, 4, 16, 32, 64, 72}));
    EXPECT_EQ(passes.Data(), RenderText(kScene).Data());
    for (const float mean : means)
        EXPECT_GT(mean, 0);
}

TEST_F(Passes, TheErrorIsImgtoolsAndFallsAsOneOverTheSamples) {
    Diagnostics log;
    const auto task = Build(kScene, log);
    const Image other = RenderText(kScene, {.seed = 1, .spp = 1024});
    ASSERT_EQ(WriteImage(other, Path("reference.exr"), ExrPixels::Float), std::nullopt);
    auto mse = MseLog::Create(Files(), task->scene->film, log);
    ASSERT_TRUE(mse);
    Image image;
    std::vector<double> errors;
    ASSERT_TRUE(Render(*task, 0, GoOn, &image, [&](int samples) {
        mse->Add(image, samples);
        errors.push_back(mse->Error());
        EXPECT_DOUBLE_EQ(mse->Error(),
                         imgtool::MeanError(*imgtool::MetricNamed("MSE"), image, other));
    }));
    // Means of 1024 pixels' squares, with heavier tails than the normal's: some 10 % each.
    EXPECT_NEAR(errors[1] / errors[4], 16, 6);
    std::istringstream lines(*ReadWholeFile(Path("mse.txt")).bytes);
    std::string line;
    int n = 0;
    for (; std::getline(lines, line); ++n)
        EXPECT_NEAR(std::stod(line.substr(line.find(',') + 1)), errors[size_t(n)],
                    1e-8 * errors[size_t(n)]);
    EXPECT_EQ(n, 6);
}

TEST_F(Passes, ReferencesThatDoNotFitAreRefused) {
    const auto says = [&](const Image &reference, const std::string &what) {
        Diagnostics log;
        const auto task = Build(kScene, log);
        ASSERT_EQ(WriteImage(reference, Path("reference.exr"), ExrPixels::Float), std::nullopt);
        EXPECT_FALSE(MseLog::Create(Files(), task->scene->film, log));
        ASSERT_EQ(log.Messages().size(), 1u);
        EXPECT_NE(log.Messages()[0].text.find(what), std::string::npos) << log.Messages()[0].text;
    };
    says(Image({32, 31}, {"R", "G", "B"}), "has the pixels [0, 32) x [0, 31), not all of");
    says(Image({32, 32}, {"Y"}), "has no channel R");
    Image wide({32, 32}, {"R", "G", "B"});
    wide.metadata.chromaticities = RGBColorSpace::Named("rec2020")->Chromaticities();
    says(wide, "has another color space than the film");
}

}  // namespace
}  // namespace pbrt::test
