// Scenes of cases/, each about a picture that is read; what is right stands in their first lines.

#include "pbrt/util/read_file.h"
#include "render/render_text.h"
#include "support/folders.h"

namespace pbrt::test {
namespace {

Image RenderCase(const std::string &name) {
    const std::string folder = SourceDir() + "/test/render/cases";
    return RenderText(*ReadWholeFile(folder + "/" + name + ".pbrt").bytes, {}, folder);
}

/// Over the pixels of channel 0.
struct Spread {
    double mean, deviation;
    int pixels;
};
Spread SpreadOf(const Image &image) {
    double sum = 0, squares = 0;
    const int n = image.Resolution().x * image.Resolution().y;
    for (int i = 0; i < n; ++i) {
        const double v = image.Data()[size_t(i) * image.NChannels()];
        sum += v, squares += v * v;
    }
    return {sum / n, std::sqrt(std::max(0., squares / n - sum / n * sum / n)), n};
}

TEST(PictureCases, FloatImagemapOfAPictureWithAlphaIsItsAlpha) {
    const Spread s = SpreadOf(RenderCase("float-imagemap-rgba"));
    // Of 64 pixels of 1024 samples, each of which sees white by a chance of 0.8; 4 sigma.
    EXPECT_NEAR(s.mean, 0.8, 4 * std::sqrt(0.8 * 0.2 / (64 * 1024)));
}

TEST(PictureCases, BilinearLooksUpTheLevelThatFits) {
    const Spread s = SpreadOf(RenderCase("bilinear-minified"));
    EXPECT_LT(s.deviation, 0.02);
    EXPECT_NEAR(s.mean, 0.5, 4 * 0.02 / std::sqrt(s.pixels));
}

TEST(PictureCases, SkiesOfFewTexelsGiveTheirIlluminance) {
    const Spread s = SpreadOf(RenderCase("small-sky-illuminance"));
    // The mean's own noise, 4 sigma of it, and the fit of white by a sigmoid, some 1e-3.
    EXPECT_NEAR(s.mean, 5 / M_PI, 4 * s.deviation / std::sqrt(s.pixels) + 2e-3);
}

}  // namespace
}  // namespace pbrt::test
