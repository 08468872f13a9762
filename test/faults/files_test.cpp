// Files that are no files, have no end, or unpack to what no memory holds.

#include <fmt/format.h>
#include <sys/stat.h>

#include "faults/faults.h"
#include "support/folders.h"
#include "support/gzipped.h"

namespace pbrt::test {
namespace {

constexpr uint64_t kGB = 1'000'000'000;

class Files : public Faults {
  protected:
    void SetUp() override {
        Faults::SetUp();
        ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0666), 0);
        Put("sparse", "");
        std::filesystem::resize_file(Path("sparse"), 1000 * kGB);
    }
    /// Directives that read the file in every way a scene has.
    static std::vector<std::string> Uses(const std::string &file) {
        const std::string name = "\"string filename\" \"" + file + "\"";
        return {"Texture \"t\" \"spectrum\" \"imagemap\" " + name,
                "Texture \"t\" \"float\" \"ptex\" " + name,
                "LightSource \"infinite\" " + name,
                "Shape \"plymesh\" " + name,
                "Material \"diffuse\" \"spectrum reflectance\" \"" + file + "\"",
                "Include \"" + file + "\"",
                "Import \"" + file + "\""};
    }
};

TEST_F(Files, SparseFilesAreRefusedBeforeMemoryIsTaken) {
    SKIP_WHERE_SANITIZED();
    for (const std::string &use : Uses("sparse")) {
        if (use.find("plymesh") != std::string::npos) continue;  // read piece by piece
        PutScene(use);
        EXPECT_TRUE(Refused(Render({.addressSpace = 3 * kGB}), "of memory")) << use;
    }
    PutScene("Shape \"plymesh\" \"string filename\" \"sparse\"");
    EXPECT_TRUE(Refused(Render({.addressSpace = 3 * kGB}), "is no PLY file"));
}

TEST_F(Files, DevicesAndPipesAreNoFilesOfAScene) {
    for (const std::string &use : Uses("/dev/zero")) {
        PutScene(use);
        EXPECT_TRUE(Refused(Render(), "device")) << use;
    }
    for (const std::string &use : Uses("pipe")) {
        PutScene(use);
        EXPECT_TRUE(Refused(Render(), "pipe")) << use;
    }
}

TEST_F(Files, ToolsRefuseThemToo) {
    const std::string feather = "Material \"featherbarbule\"";
    for (const std::string file : {"/dev/zero", "sparse"}) {
        const Limits limits{.addressSpace = kSanitized ? 0 : 3 * kGB};
        EXPECT_TRUE(Refused(Run("imgtool", {"info", file}, limits)));
        EXPECT_TRUE(Refused(Run("bsdftool", {"eval", feather, "--directions", file}, limits)));
        EXPECT_TRUE(Refused(Run("bsdftool", {"spectrum", file}, limits)));
        EXPECT_TRUE(Refused(Run("feathergen", {"--params", file, "--print-preset"}, limits)));
        EXPECT_TRUE(Refused(Run("feathergen", {"neck", "--surface", file, "--out", "o"}, limits)));
        EXPECT_TRUE(Refused(Run("pbrt", {file, "--quiet"}, limits)));
    }
}

TEST_F(Files, CompressedScenesThatUnpackWithoutEndAreRefused) {
    std::string file = Gzipped("WorldBegin\n");
    const std::string blanks = Gzipped(std::string(1'000'000, ' '));
    for (int i = 0; i < 150; ++i)
        file += blanks;
    Put("s.pbrt.gz", file);
    const Outcome outcome = Run("pbrt", {"s.pbrt.gz", "--quiet"});
    EXPECT_TRUE(Refused(outcome, "unpacks to more than 67 MB and 200 times its size"));
    PutScene("Include \"s.pbrt.gz\"");
    EXPECT_TRUE(Refused(Render(), "unpacks to more than"));
}

TEST_F(Files, PicturesThatUnpackBeyondMemoryAreRefused) {
    SKIP_WHERE_SANITIZED();
    // 16000 x 16000 zeros of one bit in 31 KB; as floats 1 GB, and as much again as a texture.
    std::filesystem::copy_file(SourceDir() + "/test/faults/bomb.png", Path("bomb.png"));
    const std::string texture =
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"bomb.png\"";
    for (const uint64_t tenths : {6, 20}) {
        PutScene(texture);
        EXPECT_TRUE(Refused(Render({.addressSpace = kGB * tenths / 10}), "of memory")) << tenths;
    }
    EXPECT_TRUE(Refused(Run("imgtool", {"info", "bomb.png"}, {.addressSpace = kGB}), "of memory"));
}

TEST_F(Files, IncludesThatDoubleAreCountedAndEnd) {
    // 2^40 inclusions.
    for (int i = 0; i < 40; ++i)
        Put(fmt::format("{}.pbrt", i),
            fmt::format("Include \"{}.pbrt\"\nInclude \"{}.pbrt\"\n", i + 1, i + 1));
    Put("40.pbrt", "# nothing\n");
    PutScene("Include \"0.pbrt\"");
    EXPECT_TRUE(Refused(Render(), "more than 300000 files are included"));
}

TEST_F(Files, IncludesThatNestWithoutEndAreRefused) {
    for (int i = 0; i < 300; ++i)
        Put(fmt::format("{}.pbrt", i), fmt::format("Include \"{}.pbrt\"\n", i + 1));
    PutScene("Include \"0.pbrt\"");
    EXPECT_TRUE(Refused(Render(), "more than 200 deep"));
}

}  // namespace
}  // namespace pbrt::test
