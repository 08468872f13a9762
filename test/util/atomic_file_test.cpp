#include "pbrt/util/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "support/temp_folder.h"

namespace pbrt {
namespace {

namespace fs = std::filesystem;

using AtomicFile = TempFolder;

std::string Read(const std::string &path) {
    return ReadWholeFile(path).bytes.value_or("(none)");
}

TEST_F(AtomicFile, WritesAndReplacesBytes) {
    const std::string path = Path("a b.bin"), bytes("x\0y\n", 4);
    EXPECT_EQ(WriteFileAtomically(path, bytes), std::nullopt);
    EXPECT_EQ(Read(path), bytes);
    EXPECT_EQ(WriteFileAtomically(path, ""), std::nullopt);
    EXPECT_EQ(Read(path), "");
    EXPECT_EQ(FileCount(), 1u);
}

TEST_F(AtomicFile, KeepsTheRightsOfTheOldFile) {
    const std::string path = Path("a");
    ASSERT_EQ(WriteFileAtomically(path, "1"), std::nullopt);
    fs::permissions(path, fs::perms(0640));
    ASSERT_EQ(WriteFileAtomically(path, "2"), std::nullopt);
    EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, FollowsLinksAndLeavesThem) {
    ASSERT_EQ(WriteFileAtomically(Path("real"), "1"), std::nullopt);
    fs::create_symlink("real", Path("link"));
    ASSERT_EQ(WriteFileAtomically(Path("link"), "2"), std::nullopt);
    EXPECT_TRUE(fs::is_symlink(Path("link")));
    EXPECT_EQ(Read(Path("real")), "2");
}

TEST_F(AtomicFile, FailureNamesTheFileAndLeavesNothing) {
    const std::string inNoFolder = Path("none/a");
    EXPECT_EQ(WriteFileAtomically(inNoFolder, "1"),
              inNoFolder + ": cannot be created: No such file or directory");
    EXPECT_EQ(WhyNotWritable(inNoFolder), WriteFileAtomically(inNoFolder, "1"));
    fs::create_directory(Path("folder"));
    EXPECT_EQ(WriteFileAtomically(Path("folder"), "1"),
              Path("folder") + ": cannot be written: Is a directory");
    EXPECT_EQ(WhyNotWritable(Path("folder")), WriteFileAtomically(Path("folder"), "1"));
    EXPECT_EQ(FileCount(), 1u);
}

TEST_F(AtomicFile, OldFileSurvivesAWriteThatBreaksOff) {
    const std::string path = Path("a");
    ASSERT_EQ(WriteFileAtomically(path, "old"), std::nullopt);
    // No file may grow beyond 100 bytes: the write stops in the middle, as on a full disk.
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{100, limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const auto error = WriteFileAtomically(path, std::string(1000, 'x'));
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, oldHandler);
    EXPECT_EQ(error, path + ": cannot be written: File too large");
    EXPECT_EQ(Read(path), "old");
    EXPECT_EQ(FileCount(), 1u);
}

TEST_F(AtomicFile, AskingForTheRightToWriteLeavesNothing) {
    EXPECT_EQ(WhyNotWritable(Path("a")), std::nullopt);
    EXPECT_EQ(FileCount(), 0u);
}

TEST_F(AtomicFile, DevicesAreWrittenInPlace) {
    EXPECT_EQ(WriteFileAtomically("/dev/null", "1"), std::nullopt);
    EXPECT_EQ(WhyNotWritable("/dev/null"), std::nullopt);
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(AtomicFile, ReadingSaysWhatIsWrong) {
    EXPECT_EQ(ReadWholeFile(Path("none")).error,
              Path("none") + ": cannot be opened: No such file or directory");
    EXPECT_EQ(ReadWholeFile(folder.string()).error,
              folder.string() + ": cannot be read: Is a directory");
}

}  // namespace
}  // namespace pbrt
