#include "pbrt/util/atomic_file.h"
#include "pbrt/util/read_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <thread>

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
    // No file may grow beyond 100 bytes: the write stops in the middle, as on a full disk. The
    // signal that goes with it would end the process.
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{100, limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const auto error = WriteFileAtomically(path, std::string(1000, 'x'));
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_EQ(error, path + ": cannot be written: File too large");
    EXPECT_EQ(Read(path), "old");
    EXPECT_EQ(FileCount(), 1u);
    EXPECT_EQ(WriteFileAtomically(path, "new"), std::nullopt) << "the signal is gone";
}

TEST_F(AtomicFile, LinksThatLeadNowhereAreWrittenThrough) {
    fs::create_directory(Path("store"));
    fs::create_symlink("second", Path("first"));
    fs::create_symlink("store/real", Path("second"));
    EXPECT_EQ(WhyNotWritable(Path("first")), std::nullopt);
    EXPECT_EQ(WriteFileAtomically(Path("first"), "1"), std::nullopt);
    EXPECT_EQ(WriteFileAtomically(Path("first"), "2"), std::nullopt);
    EXPECT_TRUE(fs::is_symlink(Path("first")) && fs::is_symlink(Path("second")));
    EXPECT_EQ(Read(Path("store/real")), "2");
    fs::create_symlink("circle", Path("circle"));
    EXPECT_EQ(WriteFileAtomically(Path("circle"), "1"),
              Path("circle") + ": cannot be written: Too many levels of symbolic links");
}

TEST_F(AtomicFile, ReadOnlyFilesAreRefused) {
    ASSERT_EQ(WriteFileAtomically(Path("a"), "mine"), std::nullopt);
    fs::permissions(Path("a"), fs::perms(0444));
    EXPECT_EQ(WriteFileAtomically(Path("a"), "other"),
              Path("a") + ": cannot be written: Permission denied");
    EXPECT_EQ(WhyNotWritable(Path("a")), WriteFileAtomically(Path("a"), "other"));
    EXPECT_EQ(Read(Path("a")), "mine");
}

TEST_F(AtomicFile, TheLongestNamesAreWritten) {
    for (const size_t length : {244, 255}) {
        const std::string path = Path(std::string(length, 'a'));
        EXPECT_EQ(WhyNotWritable(path), std::nullopt);
        EXPECT_EQ(WriteFileAtomically(path, "1"), std::nullopt);
        EXPECT_EQ(WriteFileAtomically(path, "2"), std::nullopt);
        EXPECT_EQ(Read(path), "2");
    }
    const std::string tooLong = Path(std::string(256, 'a'));
    EXPECT_EQ(WriteFileAtomically(tooLong, "1"),
              tooLong + ": cannot be written: File name too long");
    EXPECT_EQ(WhyNotWritable(tooLong), WriteFileAtomically(tooLong, "1"));
}

TEST_F(AtomicFile, NewFilesHaveTheUsersUsualRights) {
    const mode_t before = umask(027);
    EXPECT_EQ(WriteFileAtomically(Path("a"), "1"), std::nullopt);
    umask(before);
    EXPECT_EQ(fs::status(Path("a")).permissions(), fs::perms(0640));
}

TEST_F(AtomicFile, APipeWithoutReaderIsAnErrorAndNoSignal) {
    ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
    std::thread reader([&] { std::ifstream(Path("pipe")).get(); });  // one byte, and away
    const auto error = WriteFileAtomically(Path("pipe"), std::string(1 << 20, 'x'));
    reader.join();
    EXPECT_EQ(error, Path("pipe") + ": cannot be written: Broken pipe");
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

}  // namespace
}  // namespace pbrt
