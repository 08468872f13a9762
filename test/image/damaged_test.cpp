#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "image/pictures.h"
#include "image/sample_files.h"
#include "pbrt/image/image.h"
#include "pbrt/util/read_file.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

const std::vector<std::string> kRGB{"R", "G", "B"};

class Damaged : public TempFolder {
  protected:
    OrError<Image> Read(const std::string &bytes) const {
        Put("a", bytes);
        return ReadImage(Path("a"));
    }
    std::string Written(const std::string &extension, ExrPixels pixels = ExrPixels::Half) const {
        const std::string path = Path("good." + extension);
        EXPECT_EQ(WriteImage(RandomPicture({40, 30}, kRGB), path, pixels), std::nullopt);
        return *ReadWholeFile(path).bytes;
    }
    std::map<std::string, std::string> GoodFiles() const {
        return {{"half exr", Written("exr")},
                {"float exr", Written("exr", ExrPixels::Float)},
                {"png", Written("png")},
                {"pfm", Written("pfm")},
                {"hdr", SampleHdr()},
                {"jpeg", SampleJpeg(40, 30, false)},
                {"progressive jpeg", SampleJpeg(40, 30, false, true)}};
    }
};

TEST_F(Damaged, TruncatedFilesAreErrors) {
    std::mt19937 random(1);
    for (const auto &[name, good] : GoodFiles()) {
        ASSERT_TRUE(Read(good)) << name;
        std::vector<size_t> lengths{good.size() - 1, good.size() - 2, good.size() / 2};
        for (int i = 0; i < 30; ++i)
            lengths.push_back(random() % good.size());
        for (const size_t length : lengths) {
            const OrError<Image> image = Read(good.substr(0, length));
            EXPECT_FALSE(image) << name << " of " << length << " bytes of " << good.size();
            EXPECT_TRUE(image.error.starts_with(Path("a") + ": ")) << image.error;
        }
    }
}

TEST_F(Damaged, FlippedBytesNeverCrash) {
    // Where the damage passes unseen (a value, a comment) a picture of plausible size comes back.
    std::mt19937 random(2);
    for (const auto &[name, good] : GoodFiles()) {
        for (int i = 0; i < 200; ++i) {
            std::string bad = good;
            // Half of the damage goes to the header.
            const size_t reach = i % 2 ? good.size() : std::min<size_t>(good.size(), 400);
            for (int k = 0; k < 1 + i % 3; ++k)
                bad[random() % reach] ^= char(1 + random() % 255);
            const OrError<Image> image = Read(bad);
            if (image)
                EXPECT_EQ(image.value->Data().size(), size_t(image.value->Resolution().x) *
                                                          image.value->Resolution().y *
                                                          image.value->NChannels());
            else
                EXPECT_TRUE(image.error.starts_with(Path("a") + ": ")) << image.error;
        }
    }
}

TEST_F(Damaged, JpegsOfManyScansAreRefused) {
    // Each coefficient by itself, and of each the low bits one by one: 63 x bits + 1 scans of gray.
    const auto scans = [](int bits) {
        std::vector<jpeg_scan_info> all{{1, {0}, 0, 0, 0, 0}};
        for (int k = 1; k < 64; ++k)
            for (int bit = bits - 1; bit >= 0; --bit)
                all.push_back({1, {0}, k, k, bit == bits - 1 ? 0 : bit + 1, bit});
        return SampleJpeg(40, 30, true, true, all);
    };
    EXPECT_TRUE(Read(scans(7)));                     // 442
    const std::string error = Read(scans(9)).error;  // 568
    EXPECT_NE(error.find("more than 500 scans"), std::string::npos) << error;
}

TEST_F(Damaged, AbsurdSizesAreRefusedBeforeMemoryIsTaken) {
    const auto expectRefused = [&](const std::string &bytes, const std::string &reason) {
        const std::string error = Read(bytes).error;
        EXPECT_NE(error.find(reason), std::string::npos) << error;
    };
    expectRefused("PF\n100000 100000\n-1\n", "more than fit here");
    expectRefused("PF\n10000 10000\n-1\nabc", "10000 x 10000 pixels cannot come from 3 bytes");
    expectRefused("PF\n-1 4\n-1\n", "holds no pixels");
    expectRefused("#?RADIANCE\n\n-Y 20000 +X 20000\n", "cannot come from");

    std::string png = Written("png");
    const unsigned char size[8] = {0, 0, 0x40, 0, 0, 0, 0x40, 0};  // 16384 x 16384
    std::copy(size, size + 8, png.begin() + 16);
    const auto crc = crc32(0, reinterpret_cast<const unsigned char *>(&png[12]), 17);
    for (int i = 0; i < 4; ++i)
        png[29 + i] = char(crc >> (24 - 8 * i));
    expectRefused(png, "cannot come from");

    std::string exr = Written("exr");
    const size_t window = exr.find("dataWindow") + sizeof "dataWindow" + sizeof "box2i" + 4;
    exr[window + 11] = 1;  // xMax += 2^24
    expectRefused(exr, "cannot come from");
    exr[window + 11] = 0x40;  // xMax += 2^30
    EXPECT_FALSE(Read(exr));
}

}  // namespace
}  // namespace pbrt
