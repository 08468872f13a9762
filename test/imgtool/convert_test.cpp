#include "imgtool/tool_test.h"

namespace pbrt::imgtool {
namespace {

class Converting : public ToolTest {
  protected:
    /// The picture that convert makes of one with these values and options.
    Image Converted(const Image &image, std::vector<std::string> options,
                    const std::string &outfile = "out.exr") const {
        options.insert(options.begin(), {"convert", Save("in.exr", image)});
        options.insert(options.end(), {"--outfile", Path(outfile)});
        Succeed(options);
        return Load(Path(outfile));
    }
    std::vector<float> Values(const std::vector<float> &rgb,
                              const std::vector<std::string> &options) const {
        return Converted(Picture({int(rgb.size() / 3), 1}, kRGB, rgb), options).Data();
    }
    static void ExpectNear(const std::vector<float> &a, const std::vector<float> &b) {
        ASSERT_EQ(a.size(), b.size());
        for (size_t i = 0; i < a.size(); ++i)
            EXPECT_NEAR(a[i], b[i], 1e-5f * (1 + std::abs(b[i])));
    }
};

using Floats = std::vector<float>;

TEST_F(Converting, ScaleAndExposure) {
    ExpectNear(Values({1, 2, 3}, {"--scale", "3", "--exposure", "-1"}), {1.5f, 3, 4.5f});
    ExpectNear(Values({1, 2, 3}, {"--exposure=2"}), {4, 8, 12});
}

TEST_F(Converting, ClampComesBeforeScale) {
    ExpectNear(Values({1, 2, 3}, {"--scale=2", "--clamp=2"}), {2, 4, 4});
}

TEST_F(Converting, Gamma) {
    ExpectNear(Values({0.25f, 4, -1}, {"--gamma", ".5"}), {0.5f, 2, 0});
}

TEST_F(Converting, BlackAndWhite) {
    const Image gray = Converted(Picture({1, 1}, kRGB, {1, 2, 6}), {"--bw"});
    EXPECT_EQ(gray.ChannelNames(), std::vector<std::string>{"Y"});
    ExpectNear(gray.Data(), {3});
}

TEST_F(Converting, ReinhardTakesTheWhiteToOne) {
    ExpectNear(Values({4, 4, 4, 1, 1, 1}, {"--tonemap", "--maxluminance", "4"}),
               {1, 1, 1, 0.53125f, 0.53125f, 0.53125f});
}

TEST_F(Converting, PreserveColorsKeepsTheHue) {
    ExpectNear(Values({4, 2, 1, 0.5f, 0.5f, 1}, {"--preservecolors"}),
               {1, 0.5f, 0.25f, 0.5f, 0.5f, 1});
}

TEST_F(Converting, AcesFilmicEndsAtOne) {
    const Floats values = Values({0, 0.18f, 1e4f}, {"--aces-filmic"});
    EXPECT_EQ(values[0], 0);
    EXPECT_NEAR(values[1], 0.2669f, 1e-4f);
    EXPECT_EQ(values[2], 1);
}

TEST_F(Converting, DespikeTakesTheMedianOfTheNeighbours) {
    Image image({3, 3}, {"Y"});
    image.Data() = {1, 2, 3, 4, 100, 6, 7, 8, 9};
    ExpectNear(Converted(image, {"--despike", "50"}).Data(), {1, 2, 3, 4, 6, 6, 7, 8, 9});
}

TEST_F(Converting, AlphaKeepsItsValues) {
    ExpectNear(
        Converted(Picture({1, 1}, {"R", "G", "B", "A"}, {1, 2, 3, 0.5f}), {"--scale", "2"}).Data(),
        {2, 4, 6, 0.5f});
}

TEST_F(Converting, PngToPngIsIdentityWhateverTheChannels) {
    for (const auto &channels : {kRGB, {"Y"}, {"Y", "A"}, {"R", "G", "B", "A"}}) {
        Image image({16, 16}, channels);
        for (size_t i = 0; i < image.Data().size(); ++i)
            image.Data()[i] = float(i * 7 % 256) / 255;
        const std::string first = Path("first.png");
        ASSERT_EQ(WriteImage(image, first), std::nullopt);
        for (const std::string between : {"second.png", "second.exr", "second.pfm"}) {
            const std::string second = Path(between);
            Succeed({"convert", first, "--outfile", second});
            const Image a = Load(first), b = Load(second);
            const bool hasNoAlpha = between == "second.pfm" && channels.back() == "A";
            ASSERT_EQ(b.NChannels(), a.NChannels() - int(hasNoAlpha));
            const float rounding = between == "second.exr" ? 0x1p-11f : 0;  // half
            for (int c = 0; c < b.NChannels(); ++c)
                for (int i = 0; i < 256; ++i) {
                    const Point2i p{i % 16, i / 16};
                    const float before = a.Get(p, a.ChannelIndex(b.ChannelNames()[size_t(c)]));
                    EXPECT_NEAR(b.Get(p, c), before, rounding * before);
                }
        }
    }
}

TEST_F(Converting, ThreeChannelsAreThree) {
    const Image normals = Picture({1, 1}, {"N.X", "N.Y", "N.Z", "u"}, {0.25f, 0.5f, 1, 7});
    const Image png = Converted(normals, {"--channels", "N.X,N.Y,N.Z"}, "out.png");
    EXPECT_EQ(png.ChannelNames(), kRGB);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(png.Get({0, 0}, c), normals.Get({0, 0}, c), 0.005f);  // a code is up to 0.0089
}

TEST_F(Converting, ChannelsCropFlipRepeat) {
    Image image({4, 3}, kRGB);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x)
            image.Set({x, y}, 1, float(10 * y + x));
    const Image crop = Converted(image, {"--channels", "G", "--crop", "1,3,1,-2"});
    EXPECT_EQ(crop.Data(), (Floats{11, 12, 21, 22}));
    EXPECT_EQ(crop.metadata.pixelBounds, (std::array<int, 4>{1, 3, 1, 3}));
    EXPECT_EQ(crop.metadata.fullResolution, (Point2i{4, 3}));
    EXPECT_EQ(Converted(image, {"--channels=G", "--crop=0,2,0,2", "--flipy"}).Data(),
              (Floats{10, 11, 0, 1}));
    EXPECT_EQ(Converted(image, {"--channels=G", "--crop=0,2,2,3", "--repeatpix=2"}).Data(),
              (Floats{20, 20, 21, 21, 20, 20, 21, 21}));
    EXPECT_EQ(Fail({"convert", Path("in.exr"), "--outfile", Path("b.exr"), "--crop", "0,5,0,1"}),
              "imgtool: " + Path("in.exr") +
                  ": has 4 x 3 pixels: the crop [0, 5) x [0, 1) is empty or reaches beyond\n");
    EXPECT_EQ(Fail({"convert", Path("in.exr"), "--outfile", Path("b.exr"), "--channels", "N"}),
              "imgtool: " + Path("in.exr") + ": has no channel \"N\", but R, G, B\n");
}

TEST_F(Converting, ColorSpaceThereAndBack) {
    const Floats rgb{0.2f, 0.5f, 0.3f};
    const Image wide = Converted(Picture({1, 1}, kRGB, rgb), {"--colorspace", "Rec2020"});
    ASSERT_TRUE(wide.metadata.chromaticities);
    EXPECT_NEAR((*wide.metadata.chromaticities)[1][1], 0.797f, 1e-4f);
    EXPECT_NEAR(wide.Data()[0], 0.6274f * 0.2f + 0.3293f * 0.5f + 0.0433f * 0.3f, 2e-4f);
    const Image back = Converted(wide, {"--colorspace=srgb"});
    EXPECT_FALSE(back.metadata.chromaticities);
    ExpectNear(back.Data(), rgb);
    EXPECT_NE(Fail({"convert", Path("in.exr"), "--outfile", Path("b.exr"), "--colorspace", "x"})
                  .find("unknown color space \"x\"; there are \""),
              std::string::npos);
}

TEST_F(Converting, FormatsAndPixelTypes) {
    const Image image = Picture({1, 1}, kRGB, {0.1f, 0.2f, 0.3f});
    EXPECT_EQ(Converted(image, {}).metadata.storedAs, "float");
    EXPECT_EQ(Converted(image, {"--fp16"}).metadata.storedAs, "half");
    ExpectNear(Converted(image, {}, "out.pfm").Data(), image.Data());
    const Image png = Converted(image, {}, "out.PNG");
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(png.Data()[c], image.Data()[c], 3e-3f);
    EXPECT_EQ(Fail({"convert", Path("in.exr"), "--outfile", Path("a.jpg")}),
              "imgtool: " + Path("a.jpg") +
                  ": has none of the extensions that can be written: .exr, .png, .pfm\n");
}

}  // namespace
}  // namespace pbrt::imgtool
