#include "pbrt/util/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <thread>

#include "support/temp_folder.h"

namespace pbrt {
namespace {

using ReadFile = TempFolder;

TEST_F(ReadFile, HasAllBytes) {
    for (const size_t size : {0, 1, 65535, 65536, 1000000}) {
        std::string bytes(size, '\0');
        for (size_t i = 0; i < size; ++i)
            bytes[i] = char(i * i >> 7);
        Put("a", bytes);
        EXPECT_TRUE(ReadWholeFile(Path("a")).bytes == bytes) << size;
        EXPECT_TRUE(ReadWholeFile(Path("a"), Pipes::Refused, size).bytes == bytes) << size;
    }
}

TEST_F(ReadFile, SaysWhatIsWrong) {
    EXPECT_EQ(ReadWholeFile(Path("none")).error,
              Path("none") + ": cannot be opened: No such file or directory");
    EXPECT_EQ(ReadWholeFile(Path("none")).reason, "No such file or directory");
    EXPECT_EQ(ReadWholeFile(folder.string()).error,
              folder.string() + ": cannot be read: Is a directory");
    EXPECT_EQ(ReadWholeFile("/dev/zero").error,
              "/dev/zero: cannot be read: it is a device; expected a file");
    Put("a", "four");
    EXPECT_EQ(ReadWholeFile(Path("a"), Pipes::Refused, 3).error,
              Path("a") + ": cannot be read: it holds more than 3 bytes, the most that is read");
}

TEST_F(ReadFile, PipesAreTakenOnlyWhereAskedFor) {
    ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(ReadWholeFile(Path("pipe")).error,
              Path("pipe") + ": cannot be read: it is a pipe; expected a file");
    const std::string bytes(300000, 'x');
    std::thread writer([&] { std::ofstream(Path("pipe")) << bytes; });
    EXPECT_TRUE(ReadWholeFile(Path("pipe"), Pipes::Taken).bytes == bytes);
    writer.join();
}

TEST_F(ReadFile, SparseFilesAreJudgedByTheirSize) {
    Put("sparse", "");
    constexpr uint64_t kPetabyte = 1'000'000'000'000'000;
    std::error_code tooLargeForTheDisk;
    std::filesystem::resize_file(Path("sparse"), kPetabyte, tooLargeForTheDisk);
    if (tooLargeForTheDisk) std::filesystem::resize_file(Path("sparse"), kPetabyte / 64);
    EXPECT_NE(ReadWholeFile(Path("sparse")).error.find("of memory"), std::string::npos);
}

}  // namespace
}  // namespace pbrt
