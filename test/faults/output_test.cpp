// Output that cannot be written, and names that are hard to write to.

#include <sys/stat.h>

#include <thread>

#include "faults/faults.h"

namespace pbrt::test {
namespace {

namespace fs = std::filesystem;

class Output : public Faults {
  protected:
    void SetUp() override {
        Faults::SetUp();
        PutScene("Shape \"sphere\"");
    }
};

TEST_F(Output, WhatStandardOutputDoesNotTakeIsAnError) {
    ASSERT_EQ(Render().exitCode, 0);
    const std::string feather = "Material \"featherbarbule\"";
    Put("d.csv", "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0,0,1\n");
    const std::vector<std::vector<std::string>> commands{
        {"imgtool", "info", "out.pfm"},
        {"imgtool", "help"},
        {"imgtool", "diff", "--reference", "out.pfm", "out.pfm"},
        {"bsdftool", "spectrum", feather, "--samples", "16"},
        {"bsdftool", "eval", feather, "--directions", "d.csv"},
        {"bsdftool", "--help"},
        {"feathergen", "--print-preset"},
        {"feathergen", "--help"},
        {"pbrt", "--help"},
        {"pbrt", "--version"},
        {"pbrt", "scene.pbrt", "--quiet", "--stats", "--outfile", "b.pfm"}};
    for (const auto &command : commands) {
        const std::vector<std::string> args(command.begin() + 1, command.end());
        const std::string name = command[0] + " " + args[0];
        const Outcome whole = Run(command[0], args);
        EXPECT_EQ(whole.exitCode, 0) << name << ": " << whole.said;
        if (whole.said.empty()) continue;  // nothing to write
        EXPECT_TRUE(Refused(Run(command[0], args, {.out = "/dev/full"}),
                            "standard output: cannot be written: No space left on device"))
            << name;
    }
}

TEST_F(Output, NamesMayHave255Bytes) {
    for (const size_t length : {200, 244, 250, 255}) {
        const std::string name = std::string(length - 4, 'a') + ".pfm";
        const Outcome outcome = Run("pbrt", {"scene.pbrt", "--quiet", "--outfile", name});
        EXPECT_EQ(outcome.exitCode, 0) << length << ": " << outcome.said;
        EXPECT_EQ(fs::file_size(Path(name)), 16 * 16 * 12 + std::string("PF\n16 16\n-1\n").size());
    }
    EXPECT_TRUE(
        Refused(Run("pbrt", {"scene.pbrt", "--quiet", "--outfile", std::string(252, 'a') + ".pfm"}),
                "File name too long"));
}

TEST_F(Output, AFileTooLargeIsAnErrorAndThePictureIsKeptElsewhere) {
    Put("out.pfm", "old");
    // The disk that the picture belongs to takes 100 bytes of its 3084; so does the other place.
    const Outcome outcome = Render({.fileSize = 100});
    EXPECT_TRUE(Refused(outcome, "out.pfm: cannot be written: File too large"));
    EXPECT_TRUE(Refused(outcome, "neither could it be kept in"));
    EXPECT_EQ(Get("out.pfm"), "old");
    EXPECT_EQ(Files(), (std::vector<std::string>{"out.pfm", "scene.pbrt"}));
}

TEST_F(Output, APictureThatCannotBeWrittenIsKeptAmongTemporaryFiles) {
    fs::create_directory(Path("there"));
    PutScene("Shape \"sphere\"");
    setenv("TMPDIR", folder.c_str(), 1);
    // Full only when the picture is done: /dev/full takes what is opened, and no byte.
    fs::create_symlink("/dev/full", Path("full.pfm"));
    const Outcome outcome = Run("pbrt", {"scene.pbrt", "--quiet", "--outfile", "full.pfm"});
    unsetenv("TMPDIR");
    EXPECT_TRUE(Refused(outcome,
                        "full.pfm: cannot be written: No space left on device; the "
                        "picture is " +
                            Path("pbrt-")));
    const size_t at = outcome.said.find(Path("pbrt-"));
    ASSERT_NE(at, std::string::npos);
    const std::string kept = outcome.said.substr(at, outcome.said.find('\n', at) - at);
    EXPECT_TRUE(kept.ends_with("/full.exr")) << kept;
    EXPECT_EQ(Run("imgtool", {"info", kept}).exitCode, 0);
    EXPECT_TRUE(fs::is_symlink(Path("full.pfm")));
}

TEST_F(Output, ReadOnlyFilesStay) {
    Put("out.pfm", "mine");
    fs::permissions(Path("out.pfm"), fs::perms(0444));
    EXPECT_TRUE(Refused(Render(), "out.pfm: cannot be written: Permission denied"));
    EXPECT_EQ(Get("out.pfm"), "mine");
}

TEST_F(Output, LinksAreWrittenThrough) {
    fs::create_directory(Path("store"));
    fs::create_symlink("store/a.pfm", Path("out.pfm"));  // leads nowhere yet
    ASSERT_EQ(Render().exitCode, 0);
    EXPECT_TRUE(fs::is_symlink(Path("out.pfm")));
    EXPECT_TRUE(fs::is_regular_file(Path("store/a.pfm")));
}

TEST_F(Output, PipesAreWrittenInto) {
    ASSERT_EQ(mkfifo(Path("pipe.pfm").c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { got = Get("pipe.pfm"); });
    const Outcome outcome = Run("pbrt", {"scene.pbrt", "--quiet", "--outfile", "pipe.pfm"});
    reader.join();
    EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
    EXPECT_TRUE(got.starts_with("PF\n16 16\n")) << got.size();
    EXPECT_TRUE(fs::is_fifo(Path("pipe.pfm")));
}

}  // namespace
}  // namespace pbrt::test
