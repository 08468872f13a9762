#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>

#include "image/pictures.h"
#include "image/sample_files.h"
#include "pbrt/image/image.h"
#include "support/exr_parts.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

using Names = std::vector<std::string>;

class Reading : public TempFolder {
  protected:
    OrError<Image> Read(const std::string &bytes,
                        std::optional<ColorEncoding> encoding = std::nullopt) const {
        Put("a", bytes);
        return ReadImage(Path("a"), encoding);
    }
    /// PNG by libpng's simplified interface.
    std::string Png(int format, const void *pixels, const void *palette = nullptr,
                    int entries = 0) const {
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        png.width = 4;
        png.height = 1;
        png.format = format;
        png.colormap_entries = entries;
        std::string bytes(10000, '\0');
        png_alloc_size_t size = bytes.size();
        EXPECT_TRUE(png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels, 0, palette));
        bytes.resize(size);
        return bytes;
    }
};

TEST_F(Reading, JpegColorsAndGray) {
    for (const bool gray : {false, true})
        for (const bool progressive : {false, true}) {
            const OrError<Image> image =
                Read(SampleJpeg(64, 32, gray, progressive), ColorEncoding{});
            ASSERT_TRUE(image) << image.error;
            ASSERT_EQ(image.value->Resolution(), (Point2i{64, 32}));
            ASSERT_EQ(image.value->ChannelNames(), gray ? Names{"Y"} : (Names{"R", "G", "B"}));
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 64; ++x) {
                    EXPECT_NEAR(image.value->Get({x, y}, 0), x / 63.f, 0.03f);
                    if (gray) continue;
                    EXPECT_NEAR(image.value->Get({x, y}, 1), y / 31.f, 0.03f);
                }
        }
}

TEST_F(Reading, HdrBothCodings) {
    const OrError<Image> image = Read(SampleHdr());
    ASSERT_TRUE(image) << image.error;
    ASSERT_EQ(image.value->Resolution(), (Point2i{8, 2}));
    for (int x = 0; x < 8; ++x) {
        EXPECT_EQ(image.value->Get({x, 0}, 0), 1);
        EXPECT_EQ(image.value->Get({x, 0}, 1), x / 8.f);
        EXPECT_EQ(image.value->Get({x, 0}, 2), 0.5f);
        EXPECT_EQ(image.value->Get({x, 1}, 1), 0.25f);
    }
}

TEST_F(Reading, PfmOfTheOtherByteOrderAndScale) {
    const OrError<Image> image = Read(std::string("Pf\n2 1\n2.5\n\x3f\x80\0\0\x40\0\0\0", 19));
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->Data(), (std::vector<float>{2.5f, 5}));
}

TEST_F(Reading, Png16BitIsNotRoundedTo8) {
    // libpng takes 16-bit values as linear and stores them as they are.
    const uint16_t codes[4] = {0, 1, 0x1234, 0xffff};
    const OrError<Image> image = Read(Png(PNG_FORMAT_LINEAR_Y, codes), ColorEncoding{});
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->metadata.storedAs, "16-bit");
    for (int x = 0; x < 4; ++x)
        EXPECT_EQ(image.value->Get({x, 0}, 0), codes[x] / 65535.f);
}

TEST_F(Reading, PngEncodingsAndAlpha) {
    const unsigned char codes[8] = {0, 0, 64, 64, 188, 188, 255, 255};
    const std::string bytes = Png(PNG_FORMAT_GA, codes);
    const OrError<Image> sRGB = Read(bytes);
    const OrError<Image> gamma = Read(bytes, ColorEncoding{ColorEncoding::Kind::Gamma, 2});
    ASSERT_TRUE(sRGB && gamma);
    ASSERT_EQ(sRGB.value->ChannelNames(), (Names{"Y", "A"}));
    EXPECT_NEAR(sRGB.value->Get({2, 0}, 0), 0.5028865f, 1e-6f);
    EXPECT_NEAR(gamma.value->Get({2, 0}, 0), Sqr(188 / 255.f), 1e-6f);
    EXPECT_EQ(sRGB.value->Get({2, 0}, 1), 188 / 255.f);
}

TEST_F(Reading, PngPaletteIsColors) {
    const unsigned char palette[6] = {255, 0, 0, 0, 0, 255}, codes[4] = {0, 1, 1, 0};
    const OrError<Image> image = Read(Png(PNG_FORMAT_RGB_COLORMAP, codes, palette, 2));
    ASSERT_TRUE(image) << image.error;
    ASSERT_EQ(image.value->ChannelNames(), (Names{"R", "G", "B"}));
    EXPECT_EQ(image.value->Get({0, 0}, 0), 1);
    EXPECT_EQ(image.value->Get({1, 0}, 2), 1);
}

TEST_F(Reading, ExrUintChannelsOffsetsAndForeignAttributes) {
    const Imath::Box2i display({10, 20}, {19, 29}), data({12, 21}, {13, 23});
    Imf::Header header(display, data);
    header.channels().insert("id", Imf::Channel(Imf::UINT));
    unsigned ids[6] = {0, 1, 2, 3, 1u << 20, 5};
    Imf::FrameBuffer frame;
    frame.insert("id", Imf::Slice::Make(Imf::UINT, ids, data));
    {
        Imf::OutputFile file(Path("uint.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(3);
    }
    const OrError<Image> image = ReadImage(Path("uint.exr"));
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->Data(), (std::vector<float>{0, 1, 2, 3, 1u << 20, 5}));
    // Bounds count from the display window's corner.
    EXPECT_EQ(image.value->metadata.pixelBounds, (std::array<int, 4>{2, 4, 1, 4}));
    EXPECT_EQ(image.value->metadata.fullResolution, (Point2i{10, 10}));
}

TEST_F(Reading, ExrTiles) {
    const Image picture = RandomPicture({40, 30}, {"Y"});
    Imf::Header header(40, 30);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(16, 16));
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, picture.Data().data(), header.dataWindow()));
    {
        Imf::TiledOutputFile file(Path("tiles.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    }
    const OrError<Image> image = ReadImage(Path("tiles.exr"));
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->Data(), picture.Data());
}

TEST_F(Reading, ExrPartsBeyondTheFirstAreNamed) {
    WriteExrParts(Path("a.exr"), {"left", "right", "depth"}, {1, 1});
    const OrError<Image> image = ReadImage(Path("a.exr"));
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->Data(), std::vector<float>(3, 1.f));
    EXPECT_EQ(image.value->metadata.unread,
              "has 3 parts, of which only the first, \"left\", is read (others: \"right\", "
              "\"depth\")");
    WriteExrParts(Path("b.exr"), {"1", "2", "3", "4", "5", "6", "7"}, {1, 1});
    EXPECT_TRUE(ReadImage(Path("b.exr")).value->metadata.unread.ends_with("\"6\", ...)"));
    WriteExrParts(Path("c.exr"), {"all"}, {1, 1});
    EXPECT_EQ(ReadImage(Path("c.exr")).value->metadata.unread, "");
}

TEST_F(Reading, SubsampledExrIsAnError) {
    Imf::Header header(4, 4);
    header.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
    { Imf::OutputFile file(Path("yc.exr").c_str(), header); }
    EXPECT_EQ(ReadImage(Path("yc.exr")).error,
              Path("yc.exr") + ": has subsampled channels, which are not supported");
}

TEST_F(Reading, WhatIsNoPictureSaysSo) {
    EXPECT_EQ(Read("").error, Path("a") + ": is empty");
    EXPECT_EQ(Read("Shape \"sphere\"").error,
              Path("a") + ": is no EXR, PNG, JPEG, PFM, Radiance HDR, QOI or TGA picture");
    EXPECT_EQ(ReadImage(Path("none.exr")).error,
              Path("none.exr") + ": cannot be opened: No such file or directory");
}

}  // namespace
}  // namespace pbrt
