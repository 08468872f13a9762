#include "pbrt/denoise/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace pbrt {
namespace {

class Denoise : public testing::Test {
  protected:
    void SetUp() override { setenv("OIDN_LIBRARY", FAKE_OIDN, 1); }
    void TearDown() override {
        unsetenv("OIDN_LIBRARY");
        unsetenv("FAKE_OIDN_FAILS");
        unsetenv("FAKE_OIDN_LOG");
    }
    /// An image whose channel c has the value c + 1 everywhere.
    static Image Counting(std::vector<std::string> channels) {
        Image image({3, 2}, std::move(channels));
        for (size_t i = 0; i < image.Data().size(); ++i)
            image.Data()[i] = float(i % size_t(image.NChannels()) + 1);
        return image;
    }
};

TEST_F(Denoise, ChangesColorsAndNothingElse) {
    Image image = Counting({"A", "B", "G", "R", "Z"});
    image.metadata.samplesPerPixel = 16;
    const OrError<Image> denoised = Denoised(image);
    ASSERT_TRUE(denoised) << denoised.error;
    EXPECT_STREQ(std::getenv("FAKE_OIDN_LOG"), "color");
    const Image &got = *denoised.value;
    EXPECT_EQ(got.ChannelNames(), image.ChannelNames());
    EXPECT_EQ(got.metadata.samplesPerPixel, 16);
    for (int c = 0; c < 5; ++c) {
        const bool isColor = c >= 1 && c <= 3;
        EXPECT_EQ(got.Get({2, 1}, c), isColor ? float(c + 1) / 2 : float(c + 1)) << c;
    }
}

TEST_F(Denoise, GBuffersGuideIt) {
    ASSERT_TRUE(Denoised(Counting({"R", "G", "B", "Albedo.R", "Albedo.G", "Albedo.B", "N.X", "N.Y",
                                   "N.Z", "Ns.X", "Ns.Y", "Ns.Z"})));
    EXPECT_STREQ(std::getenv("FAKE_OIDN_LOG"), "albedo normal color+albedo+normal");
    ASSERT_TRUE(Denoised(Counting({"R", "G", "B", "Albedo.R", "Albedo.G", "Albedo.B"})));
    EXPECT_STREQ(std::getenv("FAKE_OIDN_LOG"), "albedo color+albedo");
}

TEST_F(Denoise, WhatIsNotFiniteCountsAsBlack) {
    Image image = Counting({"R", "G", "B"});
    image.Set({1, 1}, 0, NAN);
    image.Set({0, 0}, 2, INFINITY);
    const OrError<Image> denoised = Denoised(image);
    ASSERT_TRUE(denoised);
    EXPECT_EQ(denoised.value->Get({1, 1}, 0), 0);
    EXPECT_EQ(denoised.value->Get({0, 0}, 2), 0);
    EXPECT_EQ(denoised.value->Get({0, 0}, 0), 0.5f);
}

TEST_F(Denoise, FailuresAreTold) {
    EXPECT_EQ(Denoised(Counting({"Y"})).error, "has not the channels R, G and B");
    setenv("FAKE_OIDN_FAILS", "1", 1);
    EXPECT_EQ(Denoised(Counting({"R", "G", "B"})).error, "Open Image Denoise: out of cheese");
    setenv("OIDN_LIBRARY", "/no/such/library.so", 1);
    const std::string error = Denoised(Counting({"R", "G", "B"})).error;
    EXPECT_NE(error.find("/no/such/library.so"), std::string::npos) << error;
    EXPECT_NE(error.find("scripts/denoiser.sh installs it"), std::string::npos) << error;
    EXPECT_NE(error.find("OIDN_LIBRARY"), std::string::npos) << error;
}

}  // namespace
}  // namespace pbrt
