#include "pbrt/bsdftool/lobe_plot.h"

#include "bsdftool/tool_test.h"
#include "pbrt/bsdftool/reflectance.h"

namespace pbrt::bsdftool {
namespace {

constexpr int kSize = 32;

class Scatterograms : public BsdfTool {
  protected:
    static LobePlot View(const std::string &material, const LightAngles &light,
                         ScatterogramOptions options = {.resolution = kSize, .wavelengths = 12}) {
        return ScatterLight(Read(material), light, options, Spectrum(1));
    }
    static float Brightest(const Image &image) {
        return *std::max_element(image.Data().begin(), image.Data().end());
    }
    /// Largest difference of two pictures, one of them mirrored, relative to the brightest value.
    static float Difference(const Image &a, const Image &b, bool flipX, bool flipY) {
        float most = 0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                for (int c = 0; c < 3; ++c)
                    most = std::max(
                        most,
                        std::abs(a.Get({x, y}, c) -
                                 b.Get({flipX ? kSize - 1 - x : x, flipY ? kSize - 1 - y : y}, c)));
        return most / Brightest(a);
    }
};

TEST_F(Scatterograms, HaveTheSymmetryOfTheRow) {
    // Barbules are bent alike to both ends: light across them scatters alike along them.
    const Image across = View(kFeather, {35, 0}).ownSide;
    EXPECT_GT(Brightest(across), 0.1f);
    EXPECT_LT(Difference(across, across, false, true), 0.01f);
    EXPECT_GT(Difference(across, across, true, false), 0.5f);
    // Without tilt both sides are alike too.
    const Image upright = View(kFeather + " \"float tilt\" 0", {50, 90}).ownSide;
    EXPECT_LT(Difference(upright, upright, true, false), 0.01f);
    EXPECT_GT(Difference(upright, upright, false, true), 0.5f);
}

TEST_F(Scatterograms, BelowIsAboveTurned) {
    const std::string sparse = kFeather + " \"float spacing\" 2.5 \"float opening\" 0.4";
    const LobePlot above = View(sparse, {30, 0}), below = View(sparse, {150, 180});
    EXPECT_NEAR(above.gap, below.gap, 1e-6);
    EXPECT_GT(above.gap, 0.3);
    EXPECT_GT(Brightest(above.otherSide), 0);
    EXPECT_LT(Difference(above.ownSide, below.ownSide, true, false), 0.01f);
    EXPECT_LT(Difference(above.otherSide, below.otherSide, true, false), 0.01f);
}

TEST_F(Scatterograms, DiffuseIsADiscOfOneValue) {
    const std::string gray = "Material \"diffuse\" \"rgb reflectance\" [ .5 .5 .5 ]";
    const LobePlot f =
        View(gray, {20, 0}, {.resolution = kSize, .timesCosine = false, .wavelengths = 12});
    const LobePlot cosine = View(gray, {20, 0});
    EXPECT_EQ(Brightest(f.otherSide), 0);
    EXPECT_FALSE(f.hasGap);
    // Green, for equal energy is no white of sRGB.
    const float middle = f.ownSide.Get({kSize / 2, kSize / 2}, 1);
    EXPECT_NEAR(middle, 0.5f * InvPi * 0.948f, 0.01f);
    EXPECT_FLOAT_EQ(f.ownSide.Get({1, kSize / 2}, 1), middle);
    EXPECT_EQ(f.ownSide.Get({0, 0}, 1), 0);
    EXPECT_NEAR(cosine.ownSide.Get({kSize / 2, kSize / 2}, 1), middle, 0.001f);
    EXPECT_LT(cosine.ownSide.Get({1, kSize / 2}, 1), 0.6f * middle);
}

// f times the pixels' area sums to what sampling says is reflected; neither knows of the other.
TEST_F(Scatterograms, SumToTheReflectance) {
    const std::string material = kFeather + " \"float opening\" 0.5";
    const Image f =
        View(material, {30, 180}, {.resolution = 128, .timesCosine = false, .wavelengths = 12})
            .ownSide;
    float Y = 0;
    for (size_t i = 0; i < f.Data().size(); i += 3)
        Y += 0.2126f * f.Data()[i] + 0.7152f * f.Data()[i + 1] + 0.0722f * f.Data()[i + 2];
    const ReflectanceTable table = TabulateReflectance(
        Read(material), {.thetas = {30}, .phi = 180, .step = 10, .samples = 2048}, Spectrum(1));
    EXPECT_NEAR(Y * 4 / (128 * 128) / table.angles[0].color.Y, 1, 0.02);
}

TEST_F(Scatterograms, ExposureMakesAllButAHundredthFit) {
    const std::vector<LobePlot> views{View(kFeather, {0, 0})};
    const float exposure = AutomaticExposure(views);
    int lit = 0, tooBright = 0;
    for (size_t i = 0; i < views[0].ownSide.Data().size(); i += 3) {
        const float *rgb = &views[0].ownSide.Data()[i];
        const float most = std::max({rgb[0], rgb[1], rgb[2]}) * exposure;
        lit += most > 0;
        tooBright += most > 1.0001f;
    }
    EXPECT_GT(lit, kSize * kSize / 2);
    EXPECT_LE(tooBright, lit / 100 + 1);
    EXPECT_GT(tooBright, 0);
}

TEST_F(Scatterograms, PlotWritesAPictureOfNumbersAndOneForPeople) {
    const std::string said =
        Succeed({"plot", kFeather, "--light", "0,0", "--light", "60,-90", "--resolution", "64",
                 "--wavelengths", "8", "--exr", Path("p.exr"), "--png", Path("p.png")});
    EXPECT_EQ(said.find("exposure "), 0u);
    const Image exr = Load(Path("p.exr"));
    EXPECT_EQ(exr.Resolution(), (Point2i{128, 128}));
    EXPECT_EQ(exr.metadata.storedAs, "float");
    EXPECT_GT(Brightest(exr), 0.1f);
    // Light from -y is mirrored towards +y, the upper half.
    EXPECT_GT(exr.Get({28, 64 + 5}, 1), 5 * exr.Get({28, 128 - 6}, 1));

    const Image png = Load(Path("p.png"));
    const auto [width, height] = png.Resolution();
    size_t ink = 0, color = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float *p = png.Pixel({x, y});
            ink += y < 50 && p[0] < 0.3f;  // the title
            color += p[1] > 1.5f * p[0] && p[1] > 0.1f;
        }
    EXPECT_GT(ink, 100u);
    EXPECT_GT(color, 100u);
    EXPECT_EQ(png.Get({width - 1, 0}, 0), 1);
}

}  // namespace
}  // namespace pbrt::bsdftool
