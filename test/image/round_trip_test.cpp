#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "image/pictures.h"
#include "pbrt/image/image.h"
#include "pbrt/image/primaries.h"
#include "pbrt/util/read_file.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

const std::vector<std::string> kRGB{"R", "G", "B"};

class RoundTrip : public TempFolder {
  protected:
    Image Through(const Image &image, const std::string &name,
                  ExrPixels pixels = ExrPixels::Half) const {
        EXPECT_EQ(WriteImage(image, Path(name), pixels), std::nullopt);
        OrError<Image> read = ReadImage(Path(name));
        EXPECT_EQ(read.error, "");
        return read ? *read.value : Image({1, 1}, {"none"});
    }
};

TEST_F(RoundTrip, ExrFloatIsExact) {
    const Image image = RandomPicture({37, 19}, kRGB);
    const Image read = Through(image, "a.exr", ExrPixels::Float);
    EXPECT_EQ(read.Resolution(), image.Resolution());
    EXPECT_EQ(read.ChannelNames(), kRGB);
    EXPECT_EQ(read.Data(), image.Data());
    EXPECT_EQ(read.metadata.storedAs, "float");
}

TEST_F(RoundTrip, ExrHalfIsWithinHalfAnUlp) {
    const Image image = RandomPicture({37, 19}, kRGB);
    const Image read = Through(image, "a.EXR");
    ASSERT_EQ(read.Data().size(), image.Data().size());
    for (size_t i = 0; i < image.Data().size(); ++i)
        EXPECT_NEAR(read.Data()[i], image.Data()[i], 0x1p-11f * std::abs(image.Data()[i]));
    EXPECT_EQ(read.metadata.storedAs, "half");
}

TEST_F(RoundTrip, ExrHalfClampsWhatHalfCannotHold) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    Image image({4, 1}, {"Y"});
    image.Data() = {1e6f, -kInf, std::numeric_limits<float>::quiet_NaN(), 65504};
    const Image read = Through(image, "a.exr");
    EXPECT_EQ(read.Data()[0], 65504);
    EXPECT_EQ(read.Data()[1], -65504);
    EXPECT_TRUE(std::isnan(read.Data()[2]));
    EXPECT_EQ(read.Data()[3], 65504);
    image.Data()[2] = 0;
    EXPECT_EQ(Through(image, "a.exr", ExrPixels::Float).Data(), image.Data());
}

TEST_F(RoundTrip, ExrKeepsEveryChannelColorsFirstInEachLayer) {
    const std::vector<std::string> names{"Variance.B", "u",        "B",        "A", "Variance.R",
                                         "Ns.Z",       "Ns.X",     "Ns.Y",     "R", "dzdx",
                                         "Albedo.G",   "Albedo.R", "Albedo.B", "G", "Variance.G"};
    const Image image = RandomPicture({9, 7}, names);
    const Image read = Through(image, "a.exr", ExrPixels::Float);
    EXPECT_EQ(read.ChannelNames(),
              (std::vector<std::string>{"R", "G", "B", "A", "dzdx", "u", "Albedo.R", "Albedo.G",
                                        "Albedo.B", "Ns.X", "Ns.Y", "Ns.Z", "Variance.R",
                                        "Variance.G", "Variance.B"}));
    for (const std::string &name : names)
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 9; ++x)
                EXPECT_EQ(read.Get({x, y}, read.ChannelIndex(name)),
                          image.Get({x, y}, image.ChannelIndex(name)));
}

TEST_F(RoundTrip, ExrMetadata) {
    Image image = RandomPicture({5, 3}, kRGB);
    ImageMetadata &m = image.metadata;
    m.pixelBounds = {10, 15, 20, 23};
    m.fullResolution = {100, 50};
    m.chromaticities =
        Chromaticities{{{0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.329f}}};
    m.renderTimeSeconds = 12.5f;
    m.samplesPerPixel = 64;
    m.mse = 1e-3f;
    m.cameraFromWorld.emplace();
    m.ndcFromWorld.emplace();
    for (int i = 0; i < 16; ++i) {
        (*m.cameraFromWorld)[i / 4][i % 4] = float(i);
        (*m.ndcFromWorld)[i / 4][i % 4] = float(-i);
    }
    m.strings["comments"] = "rock dove";
    const ImageMetadata read = Through(image, "a.exr").metadata;
    EXPECT_EQ(read.pixelBounds, m.pixelBounds);
    EXPECT_EQ(read.fullResolution, m.fullResolution);
    EXPECT_EQ(read.chromaticities, m.chromaticities);
    EXPECT_EQ(read.renderTimeSeconds, m.renderTimeSeconds);
    EXPECT_EQ(read.samplesPerPixel, m.samplesPerPixel);
    EXPECT_EQ(read.mse, m.mse);
    EXPECT_EQ(read.cameraFromWorld, m.cameraFromWorld);
    EXPECT_EQ(read.ndcFromWorld, m.ndcFromWorld);
    EXPECT_EQ(read.strings, m.strings);
}

TEST_F(RoundTrip, ExrWithoutMetadataHasNone) {
    const ImageMetadata read = Through(RandomPicture({5, 3}, kRGB), "a.exr").metadata;
    EXPECT_EQ(read.pixelBounds, (std::array<int, 4>{0, 5, 0, 3}));
    EXPECT_EQ(read.fullResolution, (Point2i{5, 3}));
    EXPECT_FALSE(read.chromaticities || read.renderTimeSeconds || read.samplesPerPixel ||
                 read.mse || read.cameraFromWorld || read.ndcFromWorld);
    EXPECT_TRUE(read.strings.empty());
}

TEST_F(RoundTrip, CropMayReachBeyondThePicture) {
    Image image = RandomPicture({8, 4}, kRGB);
    image.metadata.pixelBounds = {-4, 4, -2, 2};
    image.metadata.fullResolution = {6, 6};
    const Image read = Through(image, "a.exr", ExrPixels::Float);
    EXPECT_EQ(read.metadata.pixelBounds, image.metadata.pixelBounds);
    EXPECT_EQ(read.metadata.fullResolution, image.metadata.fullResolution);
    EXPECT_EQ(read.Data(), image.Data());
}

TEST_F(RoundTrip, BoundsThatContradictTheSizeAreRefused) {
    Image image({8, 4}, kRGB);
    image.metadata.pixelBounds = {0, 8, 0, 5};
    EXPECT_EQ(WriteImage(image, Path("a.exr")),
              Path("a.exr") + ": has pixel bounds that are not the size of the picture");
    EXPECT_EQ(FileCount(), 0u);
}

TEST_F(RoundTrip, PfmIsExactInColorAndGray) {
    for (const auto &channels : {kRGB, std::vector<std::string>{"Y"}}) {
        const Image image = RandomPicture({37, 19}, channels);
        const Image read = Through(image, "a.pfm");
        EXPECT_EQ(read.ChannelNames(), channels);
        EXPECT_EQ(read.Data(), image.Data());
    }
}

TEST_F(RoundTrip, PngIsWithinHalfACode) {
    const ColorEncoding sRGB{ColorEncoding::Kind::sRGB, 1};
    for (const auto &channels : {kRGB, {"Y"}, {"Y", "A"}, {"R", "G", "B", "A"}}) {
        const Image image = RandomDisplayPicture({37, 19}, channels);
        const Image read = Through(image, "a.png");
        ASSERT_EQ(read.ChannelNames(), channels);
        for (size_t i = 0; i < image.Data().size(); ++i) {
            const float a = image.Data()[i], b = read.Data()[i];
            if (channels.size() % 2 == 0 && i % channels.size() == channels.size() - 1)
                EXPECT_NEAR(a, b, 0.501f / 255);
            else
                EXPECT_NEAR(sRGB.FromLinear(a), sRGB.FromLinear(b), 0.501f / 255);
        }
    }
}

TEST_F(RoundTrip, PngClamps) {
    Image image({4, 1}, {"Y"});
    image.Data() = {-1, 2, std::numeric_limits<float>::quiet_NaN(),
                    std::numeric_limits<float>::infinity()};
    EXPECT_EQ(Through(image, "a.png").Data(), (std::vector<float>{0, 1, 0, 1}));
}

TEST_F(RoundTrip, PngOfAnotherColorSpaceIsConverted) {
    Image image({2, 1}, kRGB);
    image.Data() = {1, 1, 1, 0.2f, 0.5f, 0.3f};
    image.metadata.chromaticities =
        Chromaticities{{{0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.329f}}};
    const Image read = Through(image, "a.pfm");
    // White stays white; ITU-R BT.2087 gives the matrix from Rec.2020 to sRGB.
    const float expected[6] = {1,
                               1,
                               1,
                               1.6605f * 0.2f - 0.5876f * 0.5f - 0.0728f * 0.3f,
                               -0.1246f * 0.2f + 1.1329f * 0.5f - 0.0083f * 0.3f,
                               -0.0182f * 0.2f - 0.1006f * 0.5f + 1.1187f * 0.3f};
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(read.Data()[i], expected[i], 2e-4f) << i;
    image.metadata.chromaticities = Chromaticities{};
    EXPECT_EQ(WriteImage(image, Path("b.pfm")),
              Path("b.pfm") + ": has chromaticities that span no color space");
}

TEST_F(RoundTrip, WithoutNamedChannelsOnlyColorsAreKept) {
    const Image image = RandomPicture({3, 3}, {"N.X", "R", "G", "B"});
    EXPECT_EQ(Through(image, "a.pfm").ChannelNames(), kRGB);
    EXPECT_EQ(WriteImage(RandomPicture({3, 3}, {"N.X", "N.Y"}), Path("b.png")),
              Path("b.png") +
                  ": needs the channels R, G and B, or Y, or one or three beside alpha in this "
                  "format");
}

/// Channel names, and which of them come back from PNG, in order, and as what.
struct Kept {
    std::vector<std::string> names, kept, as;
};

TEST_F(RoundTrip, EveryChannelSetThatCanBeToldApartIsKept) {
    const std::vector<Kept> sets{
        {{"Y"}, {"Y"}, {"Y"}},
        {{"depth"}, {"depth"}, {"Y"}},
        {{"A"}, {"A"}, {"Y"}},
        {{"Y", "A"}, {"Y", "A"}, {"Y", "A"}},
        {{"Y", "Z"}, {"Y"}, {"Y"}},
        {{"A", "Y", "Z", "u"}, {"Y", "A"}, {"Y", "A"}},
        {{"A", "X", "Y", "Z"}, {"X", "Y", "Z", "A"}, {"R", "G", "B", "A"}},
        {kRGB, kRGB, kRGB},
        {{"A", "B", "G", "R"}, {"R", "G", "B", "A"}, {"R", "G", "B", "A"}},
        {{"N.X", "N.Y", "N.Z"}, {"N.X", "N.Y", "N.Z"}, kRGB},
        {{"X", "Y", "Z"}, {"X", "Y", "Z"}, kRGB},
        {{"l.R", "l.G", "l.B", "l.A"}, {"l.R", "l.G", "l.B", "l.A"}, {"R", "G", "B", "A"}},
        {{"R", "G", "B", "l.A"}, kRGB, kRGB},
    };
    for (const auto &[names, kept, as] : sets) {
        const Image image = RandomDisplayPicture({5, 3}, names);
        const std::string all = testing::PrintToString(names);
        const Image png = Through(image, "a.png"), pfm = Through(image, "a.pfm");
        ASSERT_EQ(png.ChannelNames(), as) << all;
        // PFM has no alpha.
        ASSERT_EQ(pfm.NChannels(), as.size() < 3 ? 1 : 3) << all;
        for (size_t c = 0; c < kept.size(); ++c)
            for (int i = 0; i < 15; ++i) {
                const Point2i p{i % 5, i / 5};
                const float v = image.Get(p, image.ChannelIndex(kept[c]));
                // Half a code, and the slope of sRGB's curve, which is at most 2.28, at 1.
                EXPECT_NEAR(png.Get(p, int(c)), v, 2.28f * 0.501f / 255) << all << c;
                if (int(c) >= pfm.NChannels()) continue;
                EXPECT_EQ(pfm.Get(p, int(c)), v) << all << c;
            }
    }
    for (const std::vector<std::string> &names : {std::vector<std::string>{"u", "v"},
                                                  {"R", "G"},
                                                  {"a", "b", "c", "d"},
                                                  {"l.R", "l.G", "l.B", "m.R", "m.G", "m.B"}})
        EXPECT_NE(WriteImage(Image({2, 2}, names), Path("b.png")), std::nullopt);
}

TEST_F(RoundTrip, OnlyColorsAreConverted) {
    for (const auto &names :
         {std::vector<std::string>{"N.X", "N.Y", "N.Z"}, {"l.R", "l.G", "l.B"}}) {
        Image image({1, 1}, names);
        image.Data() = {0.2f, 0.5f, 0.3f};
        image.metadata.chromaticities = Chromaticities{
            {{0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.329f}}};
        EXPECT_EQ(Through(image, "a.pfm").Data() == image.Data(), names[0] == "N.X");
    }
}

TEST_F(RoundTrip, UnknownExtensionIsRefused) {
    const Image image({3, 3}, kRGB);
    for (const std::string name : {"a.jpg", "a", "a.exr.", "exr", "a.exr/b"}) {
        EXPECT_FALSE(CanWriteImage(name)) << name;
        EXPECT_EQ(
            WriteImage(image, Path(name)),
            Path(name) + ": has none of the extensions that can be written: .exr, .png, .pfm");
    }
    EXPECT_TRUE(CanWriteImage("a.Png") && CanWriteImage("x.y/a.pfm") && CanWriteImage(".exr"));
    EXPECT_EQ(FileCount(), 0u);
}

TEST_F(RoundTrip, FailureLeavesTheOldFileAndNothingElse) {
    const std::string path = Path("a.png");
    ASSERT_EQ(WriteImage(Image({2, 2}, kRGB), path), std::nullopt);
    const auto before = ReadWholeFile(path).bytes;
    EXPECT_NE(WriteImage(Image({2, 2}, {"N.X", "N.Y"}), path), std::nullopt);
    EXPECT_NE(WriteImage(Image({0, 0}, kRGB), path), std::nullopt);
    EXPECT_EQ(ReadWholeFile(path).bytes, before);
    EXPECT_EQ(FileCount(), 1u);
}

TEST(ColorEncoding, InvertsItself) {
    for (const ColorEncoding e : {ColorEncoding{}, ColorEncoding{ColorEncoding::Kind::sRGB, 1},
                                  ColorEncoding{ColorEncoding::Kind::Gamma, 2.2f}})
        for (int i = 0; i <= 255; ++i)
            EXPECT_NEAR(e.FromLinear(e.ToLinear(i / 255.f)), i / 255.f, 1e-6f);
}

TEST(ColorEncoding, KnownValues) {
    EXPECT_NEAR((ColorEncoding{ColorEncoding::Kind::sRGB, 1}.ToLinear(0.5f)), 0.2140411f, 1e-6f);
    EXPECT_NEAR((ColorEncoding{ColorEncoding::Kind::sRGB, 1}.FromLinear(0.002f)), 0.02584f, 1e-6f);
    EXPECT_NEAR((ColorEncoding{ColorEncoding::Kind::Gamma, 2}.ToLinear(0.5f)), 0.25f, 1e-7f);
}

TEST(SRGBTransfer, RoundTripsAndMeetsTheStandard) {
    const ColorEncoding sRGB{ColorEncoding::Kind::sRGB};
    for (int i = 0; i <= 1000; ++i) {
        const float v = i / 1000.f;
        EXPECT_NEAR(sRGB.ToLinear(sRGB.FromLinear(v)), v, 1e-6f);
    }
    EXPECT_EQ(sRGB.FromLinear(0), 0);
    EXPECT_NEAR(sRGB.FromLinear(1), 1, 1e-6);
    EXPECT_NEAR(sRGB.FromLinear(0.0031308f), 0.04045f, 1e-5f);
    EXPECT_NEAR(sRGB.ToLinear(0.5f), 0.21404f, 1e-5f);
}

}  // namespace
}  // namespace pbrt
