// Commands that print, color, balance and join pictures.

#include <cmath>

#include "imgtool/tool_test.h"
#include "pbrt/imgtool/color_map.h"
#include "pbrt/imgtool/flip.h"
#include "pbrt/spectra/color.h"
#include "pbrt/spectra/spectrum.h"

namespace pbrt::imgtool {
namespace {

class Looks : public ToolTest {};

TEST_F(Looks, CatPrintsPixelsByTheirPlaceInTheFullPicture) {
    Image image = Picture({2, 2}, kRGB, {1, 2, 3, 0.5f, 0, 0, 7, 7, 7, -1, 0, 0});
    image.metadata.pixelBounds = {10, 12, 20, 22};
    image.metadata.fullResolution = {40, 40};
    const std::string file = Save("part.exr", image);
    EXPECT_EQ(Succeed({"cat", file}),
              "(10, 20): 1,2,3\n(11, 20): 0.5,0,0\n(10, 21): 7,7,7\n(11, 21): -1,0,0\n");
    EXPECT_EQ(Succeed({"cat", "--crop", "1,-1,0,-1", file}), "(11, 20): 0.5,0,0\n");
    EXPECT_EQ(Succeed({"cat", "--pixel", "10,21", "--channels", "G", file}), "(10, 21): 7\n");
    EXPECT_EQ(Succeed({"cat", "--sort", "--channels", "R", file}),
              "(11, 21): -1\n(11, 20): 0.5\n(10, 20): 1\n(10, 21): 7\n");
    EXPECT_EQ(Succeed({"cat", "--csv", file}), "1,2,3,0.5,0,0\n7,7,7,-1,0,0\n");
    EXPECT_EQ(Succeed({"cat", "--list", file}), "{{{1,2,3},{0.5,0,0}},\n{{7,7,7},{-1,0,0}}}\n");
    EXPECT_EQ(Fail({"cat", "--pixel", "9,20", file}),
              "imgtool: " + file + ": has the pixels [10, 12) x [20, 22), not (9, 20)\n");
    EXPECT_EQ(Fail({"cat", "--csv", "--sort", file}),
              "imgtool: --csv, --list and --sort exclude one another\n");
}

void ExpectColor(const Image &image, Point2i p, const std::array<float, 3> &sRGB) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(ColorEncoding{ColorEncoding::Kind::sRGB}.FromLinear(image.Get(p, c)),
                    sRGB[size_t(c)], 1e-3f);
}

TEST_F(Looks, FalseColorGoesFromZeroToTheLargestMean) {
    const std::string file = Save("a.exr", Picture({3, 1}, kRGB, {0, 0, 0, 1, 2, 3, 4, 4, 4}));
    Succeed({"falsecolor", file, "--outfile", Path("f.exr")});
    const Image colored = Load(Path("f.exr"));
    ExpectColor(colored, {0, 0}, Viridis(0));
    ExpectColor(colored, {1, 0}, Viridis(0.5f));
    ExpectColor(colored, {2, 0}, Viridis(1));
    Succeed({"falsecolor", file, "--maxvalue", "8", "--outfile", Path("f.exr")});
    ExpectColor(Load(Path("f.exr")), {2, 0}, Viridis(0.5f));
    Succeed({"falsecolor", "--ramp", "--outfile", Path("ramp.exr")});
    ExpectColor(Load(Path("ramp.exr")), {0, 0}, Viridis(0));
    ExpectColor(Load(Path("ramp.exr")), {511, 31}, Viridis(1));
    EXPECT_EQ(Fail({"falsecolor", "--outfile", Path("f.exr")}),
              "imgtool: falsecolor needs a picture, or --ramp\n");
}

TEST_F(Looks, FalseColorTellsPlusFromMinus) {
    Succeed({"falsecolor", "--plusminus", Save("a.exr", Picture({3, 1}, {"Y"}, {-2, 0, 1})),
             "--outfile", Path("f.exr")});
    const Image colored = Load(Path("f.exr"));
    ExpectColor(colored, {0, 0}, {1, 0, 0});
    ExpectColor(colored, {1, 0}, {0, 0, 0});
    ExpectColor(colored, {2, 0}, {0, 0.5f, 0});
}

TEST(ColorMap, ViridisIsMonotoneInGreenAndTakesAnyNumber) {
    for (int i = 1; i <= 100; ++i)
        EXPECT_GT(Viridis(float(i) / 100)[1], Viridis(float(i - 1) / 100)[1]);
    EXPECT_EQ(Viridis(-1), Viridis(0));
    EXPECT_EQ(Viridis(NAN), Viridis(0));
    EXPECT_EQ(Viridis(INFINITY), Viridis(1));
}

TEST_F(Looks, WhiteBalanceMakesTheIlluminantWhite) {
    // The color of a white surface under daylight of 5000 K, in sRGB.
    const XYZ xyz = SpectrumToXYZ(Spectrum::Daylight(5000));
    const RGB rgb = RGBColorSpace::sRGB().ToRGB(xyz);
    const std::string file = Save("a.exr", Picture({1, 1}, kRGB, {rgb.r, rgb.g, rgb.b}));
    Succeed({"whitebalance", "--temperature", "5000", file, "--outfile", Path("w.exr")});
    const Image white = Load(Path("w.exr"));
    for (int c = 0; c < 3; ++c)  // chromaticities of the spectrum and of the formula differ by 2e-4
        EXPECT_NEAR(white.Get({0, 0}, c) / white.Get({0, 0}, 1), 1, 3e-3f);
    // The white of sRGB is D65: nothing to do.
    Succeed({"whitebalance", "--illuminant", "D65", file, "--outfile", Path("w.exr")});
    const Image same = Load(Path("w.exr"));
    EXPECT_NEAR(same.Get({0, 0}, 0), rgb.r, 1e-3f * rgb.r);
    EXPECT_NEAR(same.Get({0, 0}, 2), rgb.b, 1e-3f * rgb.b);
    EXPECT_EQ(Fail({"whitebalance", file, "--outfile", Path("w.exr")}),
              "imgtool: give one of --illuminant, --primaries and --temperature\n");
    EXPECT_NE(Fail({"whitebalance", file, "--illuminant", "D6", "--outfile", Path("w.exr")})
                  .find("unknown illuminant \"D6\"; there are \"A\""),
              std::string::npos);
}

TEST_F(Looks, BloomAddsAShareOfWhatIsBright) {
    std::vector<float> values(size_t(41 * 41), 0.5f);
    values[41 * 20 + 20] = 100;
    const std::string file = Save("a.exr", Picture({41, 41}, {"Y"}, values));
    Succeed({"bloom", file, "--outfile", Path("b.exr")});
    EXPECT_EQ(Load(Path("b.exr")).Data(), values) << "without a level nothing bleeds";
    Succeed({"bloom", file, "--level", "1", "--scale", "0.3", "--width", "7", "--iterations", "3",
             "--outfile", Path("b.exr")});
    const Image bloom = Load(Path("b.exr"));
    double added = 0;
    for (size_t i = 0; i < values.size(); ++i)
        added += bloom.Data()[i] - values[i];
    EXPECT_NEAR(added, 0.3 * 100, 1e-3) << "all of it, for it does not reach the border";
    EXPECT_GT(bloom.Get({20, 20}, 0), bloom.Get({21, 20}, 0));
    EXPECT_FLOAT_EQ(bloom.Get({22, 20}, 0), bloom.Get({20, 18}, 0));
    EXPECT_EQ(bloom.Get({0, 0}, 0), 0.5f);
}

TEST_F(Looks, ScaleNormalMapKeepsNormalsUnit) {
    const float s = std::sqrt(0.5f);
    const std::string file =
        Save("n.exr", Picture({2, 1}, kRGB, {0.5f, 0.5f, 1, (s + 1) / 2, 0.5f, (s + 1) / 2}));
    Succeed({"scalenormalmap", file, "--scale", "3", "--outfile", Path("s.exr")});
    const Image scaled = Load(Path("s.exr"));
    EXPECT_EQ(scaled.Get({0, 0}, 2), 1) << "flat stays flat";
    const double x = 2 * scaled.Get({1, 0}, 0) - 1, z = 2 * scaled.Get({1, 0}, 2) - 1;
    EXPECT_NEAR(x / z, 3, 1e-5);
    EXPECT_NEAR(x * x + z * z, 1, 1e-6);
    // Through 8 bits and back: what a normal map is mostly kept in.
    Succeed({"scalenormalmap", file, "--outfile", Path("n.png")});
    Succeed({"scalenormalmap", Path("n.png"), "--outfile", Path("s.exr")});
    EXPECT_NEAR(Load(Path("s.exr")).Get({1, 0}, 0), (s + 1) / 2, 3e-3f);
}

TEST_F(Looks, SplitNShowsEveryPictureAndCutsSquares) {
    const Point2i size{60, 20};
    std::vector<std::string> args{"splitn",     "--outfile", Path("split.exr"), "--crop", "2,3",
                                  "--cropsize", "4"};
    for (const float v : {0.25f, 0.5f, 0.75f})
        args.push_back(Save("p" + std::to_string(int(100 * v)) + ".exr",
                            Picture(size, {"Y"}, std::vector<float>(60 * 20, v))));
    Succeed(args);
    const Image split = Load(Path("split.exr"));
    EXPECT_EQ(split.Get({0, 0}, 0), 0.25f);
    EXPECT_EQ(split.Get({30, 10}, 0), 0.5f);
    EXPECT_EQ(split.Get({59, 19}, 0), 0.75f);
    const Image square = Load(Path("crop-p50.exr"));
    EXPECT_EQ(square.Resolution(), (Point2i{4, 4}));
    EXPECT_EQ(square.metadata.pixelBounds, (std::array<int, 4>{2, 6, 3, 7}));
    args[4] = "2";
    EXPECT_EQ(Fail(args), "imgtool: --crop: expected 2 whole numbers x,y of at least 0, found 2\n");
}

/// Two patterns that differ in colors, edges and points.
Image Pattern(int seed) {
    Image image({48, 32}, {"R", "G", "B"});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            image.Set({x, y}, 0, float((7 * x + (3 + seed) * y) % 32) / 31);
            image.Set({x, y}, 1, float((x * y + seed) % 17) / 16);
            image.Set({x, y}, 2, seed == 0 ? float(x % 5) / 4 : float(y % 3) / 2);
        }
    return image;
}

/// Figures by the authors' program, version 1.7 (PyPI's flip-evaluator), LDR, 67 pixels per degree.
TEST_F(Looks, FlipIsTheAuthors) {
    const Image a = Pattern(0), b = Pattern(2);
    const Image error = Flip(a, b);
    EXPECT_NEAR(error.Get({0, 0}, 0), 0.6598301, 1e-5);
    EXPECT_NEAR(error.Get({7, 5}, 0), 0.16242401, 1e-5);
    EXPECT_NEAR(error.Get({47, 31}, 0), 0.64646775, 1e-5);
    EXPECT_NEAR(error.Get({20, 16}, 0), 0.14836553, 1e-5);
    const std::string fileA = Save("a.exr", a), fileB = Save("b.exr", b);
    const Outcome outcome = Do({"diff", fileA, "--reference", fileB, "--metric", "flip"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.out.find("FLIP 0.36218"), std::string::npos) << outcome.out;
    EXPECT_EQ(Succeed({"diff", fileA, "--reference", fileA, "--metric", "FLIP"}), "");
    EXPECT_NE(Fail({"diff", fileA, "--reference", fileB, "--metric", "SSIM"})
                  .find("\"MRSE\" or \"FLIP\""),
              std::string::npos);
}

}  // namespace
}  // namespace pbrt::imgtool
