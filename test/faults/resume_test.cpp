// Renders that are stopped, by every way there is, and go on.

#include <signal.h>

#include <cmath>
#include <thread>

#include "faults/faults.h"
#include "pbrt/image/image.h"
#include "pbrt/util/rng.h"

namespace pbrt::test {
namespace {

using namespace std::chrono_literals;

class Resume : public Faults {
  protected:
    /// 48 x 32 pixels of a feather's ball; a second or so of one core.
    void PutBall(const std::string &film = "rgb", const std::string &more = "") const {
        Put("ball.pbrt",
            "Film \"" + film +
                "\" \"integer xresolution\" 48 \"integer yresolution\" 32\n"
                "Sampler \"independent\" \"integer pixelsamples\" 320\n"
                "LookAt 0 0 3 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n"
                "LightSource \"infinite\"\nMaterial \"featherbarbule\"\nShape \"sphere\"\n" +
                more);
    }
    std::vector<std::string> Line(const std::vector<std::string> &more) const {
        std::vector<std::string> args{"ball.pbrt", "--outfile", "out.exr"};
        args.insert(args.end(), more.begin(), more.end());
        return args;
    }
    Outcome RunBall(const std::vector<std::string> &more, const Limits &limits = {}) const {
        return Run("pbrt", Line(more), limits);
    }
    bool IsThere(const std::string &name) const { return std::filesystem::exists(Path(name)); }
    /// Stops a render by `signal` as soon as it has a first checkpoint.
    Outcome StopWithCheckpoint(int signal, const std::vector<std::string> &more = {}) const {
        std::vector<std::string> args = Line({"--checkpoint", "half.ck,0"});
        args.insert(args.end(), more.begin(), more.end());
        Process pbrt("pbrt", args, folder);
        for (int i = 0; i < 2000 && !IsThere("half.ck"); ++i)
            std::this_thread::sleep_for(2ms);
        pbrt.Signal(signal);
        return pbrt.Wait();
    }

    /// Starts a render, or goes on with one, and stops it by `signal` at a random moment of its
    /// first 150 ms; false where it was ready before.
    bool StopOnce(int signal, Rng *rng) const {
        std::vector<std::string> args = Line({"--checkpoint", "half.ck,0"});
        if (IsThere("half.ck")) args.insert(args.end(), {"--resume", "half.ck"});
        Process pbrt("pbrt", args, folder);
        std::this_thread::sleep_for(std::chrono::milliseconds(int(150 * rng->Uniform())));
        pbrt.Signal(signal);
        const Outcome outcome = pbrt.Wait();
        EXPECT_TRUE(outcome.signal == signal || outcome.exitCode == 128 + signal ||
                    outcome.exitCode == 0)
            << outcome.said;
        return outcome.exitCode != 0;
    }
    /// Stops renders at `stops` random moments, each going on where the one before ended, and
    /// expects the bytes of one that was never stopped whenever one is ready.
    void ExpectTheSame(int signal, const std::string &film, int stops) {
        PutBall(film);
        ASSERT_EQ(RunBall({"--quiet"}).exitCode, 0);
        const std::string whole = Get("out.exr");
        std::filesystem::remove(Path("out.exr"));
        Rng rng{uint64_t(signal)};
        while (stops > 0) {
            if (StopOnce(signal, &rng)) {
                --stops;
                continue;
            }
            EXPECT_TRUE(Get("out.exr") == whole);
            EXPECT_FALSE(IsThere("half.ck"));
            std::filesystem::remove(Path("out.exr"));
        }
        std::vector<std::string> more{"--quiet"};
        if (IsThere("half.ck")) more.insert(more.end(), {"--resume", "half.ck"});
        const Outcome outcome = RunBall(more);
        ASSERT_EQ(outcome.exitCode, 0) << outcome.said;
        EXPECT_TRUE(Get("out.exr") == whole);
        EXPECT_FALSE(IsThere("half.ck"));
    }
};

TEST_F(Resume, AfterSigint) {
    ExpectTheSame(SIGINT, "rgb", 50);
}

TEST_F(Resume, AfterSigterm) {
    ExpectTheSame(SIGTERM, "gbuffer", 50);
}

TEST_F(Resume, AfterSighup) {
    ExpectTheSame(SIGHUP, "spectral", 50);
}

TEST_F(Resume, AfterSigkill) {
    ExpectTheSame(SIGKILL, "rgb", 50);
}

/// A tile's judgement looks at its sums and at what they were when it was judged before.
TEST_F(Resume, WithATargetError) {
    PutBall();
    const std::vector<std::string> adaptive{"--target-error", "0.03", "--spp", "512", "--quiet"};
    ASSERT_EQ(RunBall(adaptive).exitCode, 0);
    const std::string whole = Get("out.exr");
    Rng rng{5};
    for (int i = 0; i < 8; ++i) {
        std::vector<std::string> args = Line({"--checkpoint", "half.ck,0"});
        args.insert(args.end(), adaptive.begin(), adaptive.end());
        if (IsThere("half.ck")) args.insert(args.end(), {"--resume", "half.ck"});
        Process pbrt("pbrt", args, folder);
        std::this_thread::sleep_for(std::chrono::milliseconds(int(300 * rng.Uniform())));
        pbrt.Signal(SIGTERM);
        if (pbrt.Wait().exitCode == 0) break;
    }
    std::vector<std::string> last = adaptive;
    if (IsThere("half.ck")) last.insert(last.end(), {"--resume", "half.ck"});
    ASSERT_EQ(RunBall(last).exitCode, 0);
    EXPECT_TRUE(Get("out.exr") == whole);
}

TEST_F(Resume, SaysHow) {
    PutBall();
    const Outcome outcome = StopWithCheckpoint(SIGTERM, {"--spp", "100000"});
    EXPECT_EQ(outcome.exitCode, 128 + SIGTERM);
    EXPECT_NE(outcome.said.find("Interrupted by SIGTERM: wrote the checkpoint half.ck, with "),
              std::string::npos)
        << outcome.said;
    EXPECT_NE(outcome.said.find("--resume half.ck goes on."), std::string::npos) << outcome.said;
    EXPECT_EQ(Files(), (std::vector<std::string>{"ball.pbrt", "half.ck"}));
}

TEST_F(Resume, RefusesACheckpointOfAnotherRender) {
    Image picture({2, 2}, {"R", "G", "B"});
    const std::string texture =
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.exr\"\n";
    ASSERT_EQ(WriteImage(picture, Path("t.exr")), std::nullopt);
    PutBall("rgb", texture);
    ASSERT_EQ(StopWithCheckpoint(SIGTERM, {"--spp", "100000"}).exitCode, 128 + SIGTERM);
    const std::string checkpoint = Get("half.ck");
    const auto refused = [&](const std::vector<std::string> &more, const std::string &why) {
        std::vector<std::string> args = Line({"--resume", "half.ck", "--spp", "100000"});
        args.insert(args.end(), more.begin(), more.end());
        EXPECT_TRUE(Refused(Run("pbrt", args), "--resume: half.ck " + why));
        EXPECT_TRUE(Get("half.ck") == checkpoint);
        EXPECT_FALSE(IsThere("out.exr"));
    };
    refused({"--seed", "7"}, "is a checkpoint of seed 0, and this render's is 7");
    refused({"--spp", "64"}, "is a checkpoint of 100000 samples per pixel, and now 64 are wanted");
    refused({"--pixelbounds", "0,9,0,9"},
            "is a checkpoint of the pixels [0, 48) x [0, 32), and now [0, 9) x [0, 9) are wanted");
    refused({"--sample-range", "0:64"},
            "is a checkpoint of the samples 0:100000, and now 0:64 are wanted");
    refused({"--force-diffuse"},
            "is a checkpoint of other options (render-coord-sys cameraworld; "
            "now render-coord-sys cameraworld, force-diffuse)");
    picture.Set({0, 0}, 0, 1);
    ASSERT_EQ(WriteImage(picture, Path("t.exr")), std::nullopt);
    refused({}, "is a checkpoint of another scene (a file that it names");
    PutBall("rgb", texture + "# other words\n");
    refused({}, "is a checkpoint of another scene (its text differs)");
}

TEST_F(Resume, RefusesWhatIsNoCheckpoint) {
    PutBall();
    ASSERT_EQ(StopWithCheckpoint(SIGTERM, {"--spp", "100000"}).exitCode, 128 + SIGTERM);
    const std::string right = Get("half.ck");
    const auto refused = [&](const std::string &why) {
        EXPECT_TRUE(Refused(RunBall({"--spp", "100000", "--resume", "half.ck"}), why));
    };
    for (const size_t at : {right.size() / 3, right.size() / 2, right.size() - 1}) {
        std::string damaged = right;
        damaged[at] = char(damaged[at] + 1);
        Put("half.ck", damaged);
        refused("half.ck is damaged: its checksum is wrong");
    }
    for (const size_t size : {right.size() - 1, right.size() / 2, size_t(30)}) {
        Put("half.ck", right.substr(0, size));
        refused("half.ck is damaged: its checksum is wrong");
    }
    std::string other = right;
    other[right.find('\n') - 1] = '9';
    Put("half.ck", other);
    refused("half.ck is a checkpoint of another version than ");
    Put("half.ck", "Film \"rgb\"\n");
    refused("half.ck is no checkpoint");
    std::filesystem::remove(Path("half.ck"));
    refused("half.ck: cannot be opened: No such file or directory");
}

/// RLIMIT_FSIZE stands for the disk.
TEST_F(Resume, AFullDiskLeavesTheOlderCheckpoint) {
    PutBall();
    const std::vector<std::string> many{"--spp", "1024", "--quiet"};
    ASSERT_EQ(RunBall(many).exitCode, 0);
    const std::string whole = Get("out.exr");
    ASSERT_EQ(StopWithCheckpoint(SIGTERM, many).exitCode, 128 + SIGTERM);
    const std::string older = Get("half.ck");
    {
        // Half a checkpoint (64 bytes a pixel) fits; the partial picture is a sixth of one.
        std::vector<std::string> args = Line({"--checkpoint", "half.ck,0", "--resume", "half.ck"});
        args.insert(args.end(), many.begin(), many.end());
        Process pbrt("pbrt", args, folder, {.fileSize = older.size() / 2});
        ASSERT_TRUE(
            pbrt.Says("no checkpoint: half.ck: cannot be written: File too large; "
                      "rendering goes on"));
        pbrt.Signal(SIGTERM);
        const Outcome outcome = pbrt.Wait();
        EXPECT_EQ(outcome.exitCode, 128 + SIGTERM);
        EXPECT_NE(outcome.said.find("wrote out.partial.exr"), std::string::npos) << outcome.said;
    }
    EXPECT_TRUE(Get("half.ck") == older);
    std::vector<std::string> last = many;
    last.insert(last.end(), {"--resume", "half.ck"});
    EXPECT_EQ(RunBall(last).exitCode, 0);
    EXPECT_TRUE(Get("out.exr") == whole);
}

/// All samples are there, but no room for the picture.
TEST_F(Resume, APictureThatCannotBeWrittenIsInTheCheckpoint) {
    PutBall();
    ASSERT_EQ(RunBall({"--quiet"}).exitCode, 0);
    const std::string whole = Get("out.exr");
    std::filesystem::remove(Path("out.exr"));
    std::filesystem::create_directory(Path("store"));
    setenv("TMPDIR", "/none-such", 1);  // where a picture is kept else
    Process pbrt("pbrt", {"ball.pbrt", "--outfile", "store/out.exr", "--checkpoint", "half.ck,0"},
                 folder);
    unsetenv("TMPDIR");
    for (int i = 0; i < 2000 && !IsThere("half.ck"); ++i)
        std::this_thread::sleep_for(2ms);
    std::filesystem::remove_all(Path("store"));
    const Outcome outcome = pbrt.Wait();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.said.find("All samples are in the checkpoint half.ck"), std::string::npos)
        << outcome.said;
    EXPECT_EQ(RunBall({"--quiet", "--resume", "half.ck"}).exitCode, 0);
    EXPECT_TRUE(Get("out.exr") == whole);
}

TEST_F(Resume, WithoutACheckpointWhatIsFinishedIsKept) {
    PutBall();
    for (const char *const name : {"out.exr", "out.png"}) {
        Put(name, "the old picture");
        Process pbrt("pbrt", {"ball.pbrt", "--outfile", name, "--spp", "100000"}, folder);
        ASSERT_TRUE(pbrt.Catches(SIGINT));
        std::this_thread::sleep_for(500ms);
        pbrt.Signal(SIGINT);
        const Outcome outcome = pbrt.Wait();
        EXPECT_EQ(outcome.exitCode, 128 + SIGINT);
        EXPECT_NE(outcome.said.find("Interrupted by SIGINT: wrote out.partial.exr with what is "
                                    "finished, "),
                  std::string::npos)
            << outcome.said;
        EXPECT_EQ(Get(name), "the old picture");
    }
    const OrError<Image> partial = ReadImage(Path("out.partial.exr"));
    ASSERT_TRUE(partial) << partial.error;
    const Image &image = *partial.value;
    const int samples = image.ChannelIndex("samples");
    ASSERT_GE(samples, 0);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const float n = image.Get({x, y}, samples);
            EXPECT_GE(n, 1);
            EXPECT_EQ(n, std::floor(n));
            EXPECT_EQ(n, image.Get({x / 16 * 16, y / 16 * 16}, samples)) << "one for each tile";
            // The sky is white, and seen by all pixels' rays or by what they meet.
            EXPECT_GT(image.Get({x, y}, 1), 0.01f);
        }
}

}  // namespace
}  // namespace pbrt::test
