// What is too large for the memory there is, is refused at its line before any is taken.

#include <chrono>

#include "faults/faults.h"

namespace pbrt::test {
namespace {

class FaultsOfBudget : public Faults {};

TEST_F(FaultsOfBudget, Film) {
    SKIP_WHERE_SANITIZED();
    const std::string rest = " \"integer yresolution\" 65536\nWorldBegin\n";
    for (const char *film : {"\"rgb\"", "\"gbuffer\"", "\"spectral\" \"integer nbuckets\" 4096"}) {
        Put("scene.pbrt", std::string("Film ") + film + " \"integer xresolution\" 65536" + rest);
        const std::vector<std::string> args{"scene.pbrt", "--outfile", "o.exr", "--memory-limit",
                                            "100G"};
        EXPECT_TRUE(Refused(Run("pbrt", args), "scene.pbrt:1:1: a film of 65536 x 65536 pixels"));
    }
    EXPECT_EQ(Files(), std::vector<std::string>{"scene.pbrt"});
}

/// A limit that the program sets itself.
TEST_F(FaultsOfBudget, LimitOfTheCommandLine) {
    SKIP_WHERE_SANITIZED();
    PutScene("Shape \"sphere\"", 6000);  // 3.6 GB
    const Outcome limited = Render({}, {"--memory-limit", "1G", "--spp", "1"});
    EXPECT_TRUE(Refused(limited, "needs 3.6 GB of memory, 9")) << limited.said;
    EXPECT_EQ(Render({}, {"--memory-limit=1G", "--pixel", "7,7"}).exitCode, 0);
    EXPECT_TRUE(Refused(Render({}, {"--memory-limit", "much"}), "\"much\" is no size"));
    for (const char *tool : {"imgtool", "bsdftool", "feathergen"})
        EXPECT_TRUE(Refused(Run(tool, {"--memory-limit", "much", "help"}), "is no size")) << tool;
}

TEST_F(FaultsOfBudget, ObjectsInEachOther) {
    const auto scene = [](int levels) {
        std::string text = "ObjectBegin \"0\" Shape \"sphere\" ObjectEnd\n";
        for (int i = 1; i < levels; ++i)
            text += "ObjectBegin \"" + std::to_string(i) + "\" ObjectInstance \"" +
                    std::to_string(i - 1) + "\" ObjectEnd\n";
        return text + "ObjectInstance \"" + std::to_string(levels - 1) + "\"";
    };
    PutScene(scene(1000));
    EXPECT_EQ(Render().exitCode, 0);
    PutScene(scene(1001));
    EXPECT_TRUE(Refused(Render(), "nested more than 1000 deep"));
    PutScene(scene(100000));
    EXPECT_TRUE(Refused(Render(), "nested more than 1000 deep"));
}

/// Thirty objects, each made of two of the one before: 2^30 instances, or of none.
TEST_F(FaultsOfBudget, NestedInstances) {
    SKIP_WHERE_SANITIZED();
    const auto scene = [](const std::string &innermost) {
        std::string text = "ObjectBegin \"o0\" " + innermost + " ObjectEnd\n";
        for (int i = 1; i <= 30; ++i) {
            const std::string inner = "ObjectInstance \"o" + std::to_string(i - 1) + "\" ";
            text += "ObjectBegin \"o" + std::to_string(i) + "\" " + inner + "Translate .1 0 0 " +
                    inner + "ObjectEnd\n";
        }
        return text + "ObjectInstance \"o30\"";
    };
    PutScene(scene("Shape \"sphere\""));
    const auto start = std::chrono::steady_clock::now();
    EXPECT_TRUE(
        Refused(Render({}, {"--memory-limit", "100G"}), "scene.pbrt:38:1: 1.07374e+09 instances"));
    PutScene(scene(""));
    EXPECT_EQ(Render().exitCode, 0);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

/// Mixes of two of the one before: 2^k materials, each of which may be asked for each ray.
TEST_F(FaultsOfBudget, MixesOfMixes) {
    const auto scene = [](int levels) {
        std::string text = "MakeNamedMaterial \"m0\" \"string type\" \"diffuse\"\n";
        for (int i = 1; i <= levels; ++i) {
            const std::string inner = "\"m" + std::to_string(i - 1) + "\" ";
            text += "MakeNamedMaterial \"m" + std::to_string(i) +
                    "\" \"string type\" \"mix\" \"string materials\" [" + inner + inner + "]\n";
        }
        return text + "NamedMaterial \"m" + std::to_string(levels) + "\" Shape \"sphere\"";
    };
    PutScene(scene(9));
    EXPECT_EQ(Render().exitCode, 0);
    PutScene(scene(40));
    EXPECT_TRUE(Refused(Render(), "scene.pbrt:17:1: mixes of mixes make 1024 materials"));
}

}  // namespace
}  // namespace pbrt::test
