// Full disks, for pictures and for messages.

#include <sched.h>
#include <sys/mount.h>

#include "faults/faults.h"

namespace pbrt::test {
namespace {

class FaultsOfDisks : public Faults {
  protected:
    /// A file system of so many bytes as the folder "disk", with an old picture on it. False where
    /// nobody lets us mount one; only this process and its children see it.
    bool MountDisk(int bytes) const {
        std::filesystem::create_directory(Path("disk"));
        static const bool alone = unshare(CLONE_NEWNS) == 0 &&
                                  mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
        const std::string size = "size=" + std::to_string(bytes);
        if (!alone || mount("tmpfs", Path("disk").c_str(), "tmpfs", 0, size.c_str()) != 0)
            return false;
        Put("disk/out.pfm", "the old picture");
        return true;
    }
    void UnmountDisk() const { umount(Path("disk").c_str()); }
    std::vector<std::string> OnDisk() const {
        std::vector<std::string> names;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(Path("disk")))
            names.push_back(entry.path().filename().string());
        return names;
    }
};

TEST_F(FaultsOfDisks, PictureOnAFullOne) {
    PutScene("Shape \"sphere\"", 64);  // 49 KB
    ASSERT_EQ(Render().exitCode, 0);
    const std::string right = Get("out.pfm");
    int refused = 0;
    for (int pages = 2; pages <= 16; pages += 2) {
        if (!MountDisk(pages * 4096)) GTEST_SKIP() << "no right to mount a small disk";
        const std::vector<std::string> args{"scene.pbrt", "--quiet", "--outfile", "disk/out.pfm"};
        const Outcome outcome = Run("pbrt", args);
        EXPECT_TRUE(Ended(outcome));
        EXPECT_TRUE(Get("disk/out.pfm") == (outcome.exitCode == 0 ? right : "the old picture"));
        EXPECT_EQ(OnDisk(), std::vector<std::string>{"out.pfm"});
        refused += outcome.exitCode == 1;
        UnmountDisk();
    }
    EXPECT_GT(refused, 0);
}

TEST_F(FaultsOfDisks, ConvertedOnAFullOne) {
    PutScene("Shape \"sphere\"", 64);
    ASSERT_EQ(Render().exitCode, 0);
    if (!MountDisk(6 * 4096)) GTEST_SKIP() << "no right to mount a small disk";
    EXPECT_TRUE(Refused(Run("imgtool", {"convert", "out.pfm", "--outfile", "disk/out.pfm"}),
                        "disk/out.pfm"));
    EXPECT_EQ(Get("disk/out.pfm"), "the old picture");
    EXPECT_EQ(OnDisk(), std::vector<std::string>{"out.pfm"});
    UnmountDisk();
}

TEST_F(FaultsOfDisks, FeatherOnAFullOne) {
    for (int pages : {4, 16, 64}) {
        if (!MountDisk(pages * 4096)) GTEST_SKIP() << "no right to mount a small disk";
        EXPECT_TRUE(Refused(Run("feathergen", {"--out", "disk/feather"}), "disk/feather"));
        EXPECT_EQ(OnDisk(), std::vector<std::string>{"out.pfm"});
        UnmountDisk();
    }
}

TEST_F(FaultsOfDisks, MessagesOnAFullOneCostNoPicture) {
    PutScene("Shape \"sphere\" Material \"diffuse\"");
    const std::vector<std::string> args{"scene.pbrt", "--outfile", "out.pfm"};
    EXPECT_EQ(Run("pbrt", args, {.err = "/dev/full"}).exitCode, 0);
    EXPECT_FALSE(Get("out.pfm").empty());
}

}  // namespace
}  // namespace pbrt::test
