#include "pbrt/spectra/spectrum_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "support/damaged.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

class SpectrumFile : public TempFolder {
  protected:
    OrError<SpectrumPoints> Read(const std::string &text) {
        const std::string name = Path("curve.spd");
        std::ofstream(name) << text;
        return ReadSpectrumFile(name);
    }
};

TEST_F(SpectrumFile, HoldsPairsInAnyLayout) {
    const auto read = Read("# title 1 2\n400 0.5 # trailing 7\n\t500\n+1e0 600 -.25\r\n");
    ASSERT_TRUE(read) << read.error;
    EXPECT_EQ(read.value->lambda, (std::vector<float>{400, 500, 600}));
    EXPECT_EQ(read.value->values, (std::vector<float>{0.5f, 1, -0.25f}));
}

TEST_F(SpectrumFile, ErrorsNameFileAndLine) {
    const std::pair<const char *, const char *> cases[] = {
        {"400 1\n500 x2\n", ":2: \"x2\" is not a number"},
        {"400 1\n500 nan\n", ":2: \"nan\" is not a number"},
        {"400 1 500 inf\n", ":1: \"inf\" is not a number"},
        {"400 1,5\n", ":1: \"1,5\" is not a number"},
        {"400 1\n\n400 2\n", ":3: wavelength 400 is not greater"},
        {"400 1 500\n", "ends with a wavelength that has no value"},
        {"# nothing\n", "holds no spectrum"},
        {"0.3 1 0.7 1", "covers 0.3 to 0.7 nm, nothing of 360 to 830; are these micrometres?"},
        {"900 1 1700 1", "covers 900 to 1700 nm, nothing of 360 to 830"},
        {"200 1 359 1", "covers 200 to 359 nm, nothing of 360 to 830"},
    };
    for (const auto &[text, message] : cases) {
        const auto read = Read(text);
        EXPECT_FALSE(read) << text;
        EXPECT_NE(read.error.find(message), std::string::npos) << read.error;
        EXPECT_NE(read.error.find("curve.spd"), std::string::npos) << read.error;
    }
}

TEST(SpectrumPoints, EndsAreHeldOutToTheVisibleRange) {
    using Floats = std::vector<float>;
    const SpectrumPoints held = HoldingEnds({{400, 700}, {1, 3}});
    EXPECT_EQ(held.lambda, (Floats{360, 400, 700, 830}));
    EXPECT_EQ(held.values, (Floats{1, 1, 3, 3}));
    EXPECT_EQ(HoldingEnds({{550}, {2}}).values, (Floats{2, 2, 2}));
    const SpectrumPoints wide = HoldingEnds({{360, 500, 900}, {1, 2, 3}});
    EXPECT_EQ(wide.lambda, (Floats{360, 500, 900}));
}

TEST_F(SpectrumFile, MissingIsAnError) {
    const auto read = ReadSpectrumFile("/nowhere/curve.spd");
    EXPECT_FALSE(read);
    EXPECT_EQ(read.error, "/nowhere/curve.spd: cannot be opened: No such file or directory");
}

TEST_F(SpectrumFile, AFolderIsAnError) {
    const auto read = ReadSpectrumFile(folder.string());
    EXPECT_FALSE(read);
    EXPECT_FALSE(read.error.empty());
}

TEST_F(SpectrumFile, MessagesShowNoLongWords) {
    const auto read = Read("400 " + std::string(1 << 20, 'x') + "\n");
    EXPECT_FALSE(read);
    EXPECT_LT(read.error.size(), folder.string().size() + 120) << read.error.size();
}

TEST_F(SpectrumFile, DamagedFilesAreReadOrRefused) {
    std::string good = "# a curve\n";
    for (int i = 0; i < 40; ++i)
        good += std::to_string(380 + 10 * i) + " 0." + std::to_string(i * 7919) + "\n";
    std::mt19937 random(4);
    for (int i = 0; i < 500; ++i) {
        const auto read = Read(Damaged(good, random));
        EXPECT_NE(bool(read), !read.error.empty());
        if (!read) continue;
        ASSERT_EQ(read.value->lambda.size(), read.value->values.size());
        for (size_t k = 1; k < read.value->lambda.size(); ++k)
            EXPECT_LT(read.value->lambda[k - 1], read.value->lambda[k]);
    }
}

}  // namespace
}  // namespace pbrt
