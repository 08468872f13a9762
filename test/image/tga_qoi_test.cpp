#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pbrt/image/image.h"
#include "support/damaged.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

using Names = std::vector<std::string>;
constexpr ColorEncoding kLinear{};

class SmallFiles : public TempFolder {
  protected:
    OrError<Image> Read(const std::string &bytes) const {
        Put("a", bytes);
        return ReadImage(Path("a"), kLinear);
    }
    /// Reads the file, and every beginning of it, which is an error that names the file.
    Image ReadWhole(const std::string &bytes, const std::string &what) const {
        for (size_t n = 0; n < bytes.size(); ++n) {
            const OrError<Image> cut = Read(bytes.substr(0, n));
            EXPECT_FALSE(cut) << what << " of " << n << " bytes";
            EXPECT_TRUE(cut.error.starts_with(Path("a") + ": ")) << cut.error;
        }
        return ReadGood(bytes, what);
    }
    Image ReadGood(const std::string &bytes, const std::string &what) const {
        OrError<Image> image = Read(bytes);
        EXPECT_TRUE(image) << what << ": " << image.error;
        return image ? *std::move(image.value) : Image({1, 1}, {"Y"});
    }
};

std::string Short(int v) {
    return {char(v & 255), char(v >> 8)};
}

/// A TGA file of 3 x 2 pixels, whose codes are given row by row from the top.
struct TgaFile {
    int kind = 2, bits = 24, descriptor = 32;
    std::vector<std::string> pixels{};  ///< of six
    std::vector<std::string> palette{};
    int firstEntry = 0, entryBits = 0;

    std::string Bytes(bool isPacked) const {
        const bool fromRight = descriptor & 16, fromTop = descriptor & 32;
        std::string file{char(2), char(!palette.empty()), char(kind + (isPacked ? 8 : 0))};
        file += Short(firstEntry) + Short(int(palette.size())) + char(entryBits);
        file += Short(0) + Short(0) + Short(3) + Short(2) + char(bits) + char(descriptor) + "id";
        for (const std::string &entry : palette)
            file += entry;
        std::vector<std::string> stored;
        for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 3; ++column)
                stored.push_back(pixels[size_t((fromTop ? row : 1 - row) * 3 +
                                               (fromRight ? 2 - column : column))]);
        if (!isPacked) {
            for (const std::string &pixel : stored)
                file += pixel;
            return file;
        }
        // Runs where pixels repeat, across the row's end, too; else one by one.
        for (size_t i = 0; i < stored.size();) {
            size_t n = 1;
            while (i + n < stored.size() && stored[i + n] == stored[i])
                ++n;
            file += n > 1 ? char(127 + n) : char(0);
            file += stored[i];
            i += n;
        }
        return file;
    }
};

/// Six pixels as TGA codes and as values.
struct TgaKind {
    const char *name;
    TgaFile file;
    Names channels;
    std::vector<float> values;
};

std::string Bgr555(int r, int g, int b) {
    return Short(r << 10 | g << 5 | b);
}

std::vector<TgaKind> TgaKinds() {
    const std::string red("\0\0\xff", 3), orange("\x00\x33\xff", 3), gray("\x66\x66\x66", 3);
    const std::vector<float> colors{1,   0,   0,   1,   0,   0,   1, .2f, 0,
                                    .4f, .4f, .4f, .4f, .4f, .4f, 1, 0,   0};
    const Names rgb{"R", "G", "B"}, rgba{"R", "G", "B", "A"};
    const auto with = [](std::string code, int alpha) { return code + char(alpha); };
    std::vector<TgaKind> kinds;
    kinds.push_back({"24 bits", {2, 24, 32, {red, red, orange, gray, gray, red}}, rgb, colors});
    kinds.push_back(
        {"32 bits",
         {2,
          32,
          40,
          {with(red, 0), with(red, 51), with(red, 51), with(gray, 255), with(gray, 255),
           with(red, 0)}},
         rgba,
         {1, 0, 0, 0, 1, 0, 0, .2f, 1, 0, 0, .2f, .4f, .4f, .4f, 1, .4f, .4f, .4f, 1, 1, 0, 0, 0}});
    kinds.push_back({"32 bits without alpha",
                     {2,
                      32,
                      32,
                      {with(red, 0), with(red, 0), with(orange, 0), with(gray, 0), with(gray, 0),
                       with(red, 0)}},
                     rgb,
                     colors});
    const std::vector<float> of5Bits{1, 0,        0, 1, 0, 0, 0, 1 / 31.f, 1,
                                     0, 1 / 31.f, 1, 0, 0, 0, 1, 1,        1};
    for (const int bits : {15, 16})
        kinds.push_back({bits == 15 ? "15 bits" : "16 bits",
                         {2,
                          bits,
                          33,
                          {Bgr555(31, 0, 0), Bgr555(31, 0, 0), Bgr555(0, 1, 31), Bgr555(0, 1, 31),
                           Bgr555(0, 0, 0), Bgr555(31, 31, 31)}},
                         rgb,
                         of5Bits});
    kinds.push_back({"gray",
                     {3, 8, 32, {"\xff", "\xff", "\x33", "\x66", "\x66", "\xff"}},
                     {"Y"},
                     {1, 1, .2f, .4f, .4f, 1}});
    kinds.push_back(
        {"gray and alpha",
         {3, 16, 40, {"\xff\x33", "\xff\x33", "\x33\xff", "\x33\xff", "\x66\x66", "\xff\x33"}},
         {"Y", "A"},
         {1, .2f, 1, .2f, .2f, 1, .2f, 1, .4f, .4f, 1, .2f}});
    for (const int index : {8, 16}) {
        const auto at = [&](int i) { return index == 8 ? std::string(1, char(i)) : Short(i); };
        const std::vector<std::string> pixels{at(7), at(7), at(8), at(9), at(9), at(7)};
        kinds.push_back(
            {"palette", {1, index, 32, pixels, {red, orange, gray}, 7, 24}, rgb, colors});
        kinds.push_back({"palette of 16 bits",
                         {1,
                          index,
                          32,
                          {at(0), at(0), at(1), at(1), at(2), at(3)},
                          {Bgr555(31, 0, 0), Bgr555(0, 1, 31), Bgr555(0, 0, 0), Bgr555(31, 31, 31)},
                          0,
                          16},
                         rgb,
                         of5Bits});
        kinds.push_back({"palette with alpha",
                         {1,
                          index,
                          32,
                          {at(0), at(1), at(1), at(0), at(0), at(1)},
                          {with(red, 51), with(gray, 255)},
                          0,
                          32},
                         rgba,
                         {1, 0, 0, .2f, .4f, .4f, .4f, 1,   .4f, .4f, .4f, 1,
                          1, 0, 0, .2f, 1,   0,   0,   .2f, .4f, .4f, .4f, 1}});
    }
    return kinds;
}

std::string QoiFile(int width, int height, int channels, int isLinear, const std::string &chunks) {
    std::string file = "qoif";
    for (const int v : {width, height})
        file += {char(v >> 24), char(v >> 16), char(v >> 8), char(v)};
    return file + char(channels) + char(isLinear) + chunks + std::string("\0\0\0\0\0\0\0\1", 8);
}

TEST_F(SmallFiles, TgaOfEveryKind) {
    for (TgaKind &kind : TgaKinds())
        for (const bool isPacked : {false, true})
            for (const int corner : {0, 16, 32, 48}) {
                const std::string what =
                    fmt::format("{}, packed {}, corner {}", kind.name, isPacked, corner);
                kind.file.descriptor = (kind.file.descriptor & 15) | corner;
                const std::string bytes = kind.file.Bytes(isPacked);
                const Image image = corner == 32 ? ReadWhole(bytes, what) : ReadGood(bytes, what);
                EXPECT_EQ(image.Resolution(), (Point2i{3, 2})) << what;
                EXPECT_EQ(image.ChannelNames(), kind.channels) << what;
                EXPECT_EQ(image.Data(), kind.values) << what;
            }
}

TEST_F(SmallFiles, TgaIsDecodedBySRGBUnlessToldOtherwise) {
    const std::string gray = TgaFile{3, 8, 32, std::vector<std::string>(6, "\xbc")}.Bytes(true);
    Put("a.tga", gray);
    EXPECT_NEAR(ReadImage(Path("a.tga")).value->Get({0, 0}, 0), 0.5028865f, 1e-6f);
}

TEST_F(SmallFiles, FlippedBytesNeverCrash) {
    std::mt19937 random(1);
    for (const TgaKind &kind : TgaKinds())
        for (int i = 0; i < 40; ++i) {
            const OrError<Image> image = Read(Damaged(kind.file.Bytes(i % 2), random));
            EXPECT_TRUE(image || image.error.starts_with(Path("a") + ": ")) << image.error;
        }
    for (int i = 0; i < 1000; ++i)
        Read(Damaged(
            QoiFile(4, 2, 4, 0, "\xff\x01\x02\x03\x33\x80\x7f\x40\xc1\x10\x20\xfe\x01\x02\x03"),
            random));
}

TEST_F(SmallFiles, DamagedTgaSaysWhy) {
    const auto errorOf = [&](TgaFile file, bool isPacked = false) {
        file.pixels.assign(6, std::string(3, '\x10'));
        return Read(file.Bytes(isPacked)).error.substr(Path("a").size() + 2);
    };
    EXPECT_EQ(errorOf({.bits = 12}), "is damaged: a TGA picture of 12 bits a pixel");
    EXPECT_EQ(errorOf({.kind = 1, .bits = 8}), "is damaged: a palette of 0 colors of 0 bits");
    EXPECT_EQ(errorOf({.kind = 1, .bits = 8, .palette = {"abc"}, .entryBits = 24}),
              "is damaged: a pixel has no color in the palette");
    EXPECT_EQ(errorOf({.descriptor = 64}),
              "is a TGA picture of interleaved rows, which are not supported");
    std::string huge = TgaFile{.pixels = std::vector<std::string>(6, "abc")}.Bytes(true);
    huge[13] = char(255);
    EXPECT_NE(Read(huge).error.find("cannot come from"), std::string::npos);
    std::string overfull = TgaFile{.pixels = std::vector<std::string>(6, "abc")}.Bytes(true);
    overfull[20] = char(128 + 6);  // seven of six pixels
    EXPECT_NE(Read(overfull).error.find("damaged"), std::string::npos);
}

TEST_F(SmallFiles, QoiOfEveryChunk) {
    std::string chunks;
    chunks += "\xfe\x10\x20\x30";                   // colors
    chunks += "\xc1";                               // twice again
    chunks += char(0x40 | 3 << 4 | 2 << 2 | 0);     // + 1, 0, -2
    chunks += {char(0x80 | (32 - 9)), char(0x0f)};  // green -9; red -8 and blue +7 from it
    chunks += "\xff\x01\x02\x03\x33";               // colors and alpha
    chunks += char((0x10 * 3 + 0x20 * 5 + 0x30 * 7 + 255 * 11) % 64);  // the first one
    chunks += char(0x40 | 0 << 4 | 0 << 2 | 0);                        // - 2 each
    const std::vector<std::array<int, 4>> codes{
        {16, 32, 48, 255}, {16, 32, 48, 255}, {16, 32, 48, 255}, {17, 32, 46, 255},
        {0, 23, 44, 255},  {1, 2, 3, 51},     {16, 32, 48, 255}, {14, 30, 46, 255}};
    for (const int channels : {3, 4}) {
        const Image image =
            ReadWhole(QoiFile(4, 2, channels, 0, chunks), fmt::format("{}", channels));
        ASSERT_EQ(image.Resolution(), (Point2i{4, 2}));
        ASSERT_EQ(image.NChannels(), channels);
        for (size_t i = 0; i < codes.size(); ++i)
            for (size_t c = 0; c < size_t(channels); ++c)
                EXPECT_EQ(image.Data()[i * size_t(channels) + c], float(codes[i][c]) / 255)
                    << i << c;
    }
}

TEST_F(SmallFiles, QoiSaysWhetherItIsLinear) {
    for (const int isLinear : {0, 1}) {
        Put("a.qoi", QoiFile(1, 1, 3, isLinear, "\xfe\xbc\xbc\xbc"));
        EXPECT_NEAR(ReadImage(Path("a.qoi")).value->Get({0, 0}, 0),
                    isLinear ? 188 / 255.f : 0.5028865f, 1e-6f);
    }
}

TEST_F(SmallFiles, DamagedQoiSaysWhy) {
    EXPECT_NE(Read(QoiFile(1, 1, 5, 0, "\xc0")).error.find("its header is none"),
              std::string::npos);
    EXPECT_NE(Read(QoiFile(0, 1, 3, 0, "\xc0")).error.find("holds no pixels"), std::string::npos);
    EXPECT_NE(Read(QoiFile(10000, 10000, 3, 0, "\xc0")).error.find("cannot come from"),
              std::string::npos);
    EXPECT_NE(Read(QoiFile(-1, -1, 3, 0, "\xc0")).error.find("more than fit here"),
              std::string::npos);
}

}  // namespace
}  // namespace pbrt
