// Signals while pbrt renders, and while it waits to write.

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <memory>
#include <thread>

#include "faults/faults.h"

namespace pbrt::test {
namespace {

using namespace std::chrono_literals;

class FaultsOfSignals : public Faults {
  protected:
    /// Samples for hours.
    std::unique_ptr<Process> StartEndless(const Limits &limits = {}) const {
        PutScene("Shape \"sphere\"");
        Put("out.pfm", "the old picture");
        return std::make_unique<Process>(
            "pbrt",
            std::vector<std::string>{"scene.pbrt", "--spp", "16777216", "--outfile", "out.pfm"},
            folder, limits);
    }
    /// And what is finished beside it.
    void ExpectTheOldPicture() const {
        EXPECT_EQ(Get("out.pfm"), "the old picture");
        std::filesystem::remove(Path("out.partial.exr"));
        EXPECT_EQ(Files(), (std::vector<std::string>{"out.pfm", "scene.pbrt"}));
    }
};

TEST_F(FaultsOfSignals, OneEndsRenderingWithASentence) {
    const struct {
        int number;
        const char *name;
    } signals[] = {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
    for (const auto &s : signals) {
        const auto pbrt = StartEndless();
        ASSERT_TRUE(pbrt->Catches(s.number));
        pbrt->Signal(s.number);
        const Outcome outcome = pbrt->Wait();
        EXPECT_EQ(outcome.exitCode, 128 + s.number);
        EXPECT_NE(outcome.said.find(std::string("Interrupted by ") + s.name), std::string::npos)
            << outcome.said;
        ExpectTheOldPicture();
    }
}

TEST_F(FaultsOfSignals, HangingUpIsIgnoredUnderNohup) {
    const auto pbrt = StartEndless({.ignored = SIGHUP});
    ASSERT_TRUE(pbrt->Catches(SIGTERM));
    pbrt->Signal(SIGHUP);
    std::this_thread::sleep_for(200ms);
    pbrt->Signal(SIGTERM);
    EXPECT_EQ(pbrt->Wait().exitCode, 128 + SIGTERM);
}

/// A FIFO that nobody reads.
TEST_F(FaultsOfSignals, OneEndsWaitingForAReader) {
    PutScene("Shape \"sphere\"");
    ASSERT_EQ(mkfifo(Path("out.pfm").c_str(), 0600), 0);
    setenv("TMPDIR", folder.c_str(), 1);  // where the picture is kept
    Process pbrt("pbrt", {"scene.pbrt", "--outfile", "out.pfm"}, folder);
    unsetenv("TMPDIR");
    ASSERT_TRUE(pbrt.Says("done"));
    std::this_thread::sleep_for(500ms);  // for it to open the file
    pbrt.Signal(SIGTERM);
    const Outcome outcome = pbrt.Wait(20s);
    EXPECT_EQ(outcome.exitCode, 128 + SIGTERM) << outcome.said;
    EXPECT_NE(outcome.said.find("the picture is " + Path("pbrt-")), std::string::npos)
        << outcome.said;
}

/// A FIFO whose reader is asleep.
TEST_F(FaultsOfSignals, TwoEndWriting) {
    PutScene("Shape \"sphere\"", 64);
    ASSERT_EQ(mkfifo(Path("out.pfm").c_str(), 0600), 0);
    const int reader = open(Path("out.pfm").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    ASSERT_GT(fcntl(reader, F_SETPIPE_SZ, 4096), 0);
    Process pbrt("pbrt", {"scene.pbrt", "--outfile", "out.pfm"}, folder);
    ASSERT_TRUE(pbrt.Says("done"));
    for (int i = 0; i < 2; ++i) {
        std::this_thread::sleep_for(500ms);
        pbrt.Signal(SIGTERM);
    }
    const Outcome outcome = pbrt.Wait(20s);
    EXPECT_TRUE(outcome.signal == SIGTERM || outcome.exitCode == 128 + SIGTERM) << outcome.said;
    close(reader);
}

}  // namespace
}  // namespace pbrt::test
