// Scenes of cases/, each about a picture that is read; what is right stands in their first lines.

#include <algorithm>
#include <array>

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

// A third of the picture for each vane; its middle, for the edges are the filter's.
TEST(PictureCases, CellsHaveColoursAndUnevenFilmsPaleOnes) {
    const Image image = RenderCase("feather-cells");
    struct Middle {
        double saturation = 0, spread = 0;
    };
    const auto middleOf = [&](int third) {
        std::array<double, 3> sum{};
        double squares = 0;
        int n = 0;
        for (int y = 10; y < 23; ++y)
            for (int x = 33 * third + 10; x < 33 * third + 23; ++x, ++n)
                for (int c = 0; c < 3; ++c) {
                    const double v = image.Get({x, y}, c);
                    sum[size_t(c)] += v;
                    if (c == 1) squares += v * v;
                }
        const double most = std::max({sum[0], sum[1], sum[2]}),
                     least = std::min({sum[0], sum[1], sum[2]});
        const double mean = sum[1] / n;
        return Middle{1 - least / most, std::sqrt(std::max(0., squares / n - mean * mean)) / mean};
    };
    const Middle even = middleOf(0), cells = middleOf(1), uneven = middleOf(2);
    EXPECT_GT(even.saturation, 0.5);
    EXPECT_LT(uneven.saturation, 0.6 * even.saturation);
    // 64 samples of four wavelengths each against cells that differ by half and more.
    EXPECT_LT(even.spread, 0.2);
    EXPECT_LT(uneven.spread, 0.2);
    EXPECT_GT(cells.spread, 0.4);
}

}  // namespace
}  // namespace pbrt::test
