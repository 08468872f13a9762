#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pbrt {

/// A folder of its own for each test, removed with everything in it.
class TempFolder : public testing::Test {
  protected:
    void SetUp() override {
        const testing::TestInfo *test = testing::UnitTest::GetInstance()->current_test_info();
        folder = std::filesystem::path(testing::TempDir()) /
                 (std::string("pbrt-") + test->test_suite_name() + "-" + test->name() + "-" +
                  std::to_string(getpid()));
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::string Path(const std::string &name) const { return (folder / name).string(); }
    size_t FileCount() const {
        return size_t(std::distance(std::filesystem::directory_iterator(folder),
                                    std::filesystem::directory_iterator()));
    }
    /// Puts the bytes into a new file; faster than the atomic writer, which waits for the disk, as
    /// ext4 does when an old file is overwritten.
    void Put(const std::string &name, const std::string &bytes) const {
        std::filesystem::remove(Path(name));
        std::ofstream(Path(name), std::ios::binary) << bytes;
    }
    std::filesystem::path folder;
};

}  // namespace pbrt
