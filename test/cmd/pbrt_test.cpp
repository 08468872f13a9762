// The program `pbrt` as a user meets it: exit codes, messages, files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "pbrt/image/image.h"
#include "support/folders.h"
#include "support/shell.h"

namespace pbrt {
namespace {

namespace fs = std::filesystem;

class Program : public testing::Test {
  protected:
    void SetUp() override {
        folder = fs::temp_directory_path() /
                 ("pbrt-cmd-" + std::to_string(getpid()) + "-" +
                  testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    Outcome Run(const std::string &arguments, const std::string &before = "") {
        return Shell("cd '" + folder.string() + "' && " + before + " '" + ProgramDir() + "/pbrt' " +
                     arguments);
    }
    void Write(const std::string &name, const std::string &text) {
        std::ofstream(folder / name) << text;
    }
    std::string Read(const std::string &name) {
        std::stringstream text;
        text << std::ifstream(folder / name).rdbuf();
        return text.str();
    }
    /// Names of the files in the folder, but for scene.pbrt.
    std::vector<std::string> Files() {
        std::vector<std::string> names;
        for (const auto &entry : fs::directory_iterator(folder))
            if (entry.path().filename() != "scene.pbrt")
                names.push_back(entry.path().filename().string());
        return names;
    }

    fs::path folder;
};

constexpr char kScene[] =
    "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 8 \"string filename\" "
    "\"out.exr\"\nSampler \"zsobol\" \"integer pixelsamples\" 4\nWorldBegin\n"
    "LightSource \"infinite\"\nTranslate 0 0 3 Shape \"sphere\"\n";

TEST_F(Program, RendersTheNamedFile) {
    Write("scene.pbrt", kScene);
    EXPECT_EQ(Run("scene.pbrt --quiet").exitCode, 0);
    const auto image = ReadImage((folder / "out.exr").string());
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->Resolution(), (Point2i{16, 8}));
    EXPECT_EQ(image.value->metadata.samplesPerPixel, 4);
}

TEST_F(Program, OptionsOfEverySpelling) {
    Write("scene.pbrt", kScene);
    for (const char *options : {"--outfile a.exr --spp 1 --nthreads 1", "-outfile=a.exr -spp 1",
                                "--OutFile a.exr --n_threads 2",
                                "--outfile a.exr --cropwindow 0,0.5,0,1 --seed 3 --quick"})
        EXPECT_EQ(Run(std::string("scene.pbrt --quiet ") + options).exitCode, 0) << options;
    EXPECT_EQ(Files(), std::vector<std::string>{"a.exr"});
    const auto image = ReadImage((folder / "a.exr").string());
    EXPECT_EQ(image.value->Resolution(), (Point2i{2, 2}));
    EXPECT_EQ(image.value->metadata.fullResolution, (Point2i{4, 2}));
}

TEST_F(Program, ScenesOfPbrtV3AreUpgradedToStandardOutput) {
    Write("old.pbrt",
          "Film \"image\" \"string filename\" \"out.exr\" \"integer xresolution\" 8\n"
          "\"integer yresolution\" 4\nSampler \"random\" \"integer pixelsamples\" 1\nWorldBegin\n"
          "LightSource \"point\" \"point from\" [ 0 0 0 ]\nWorldEnd\n");
    const Outcome refused = Run("old.pbrt");
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.said.find("\"pbrt --upgrade old.pbrt > new.pbrt\""), std::string::npos)
        << refused.said;
    EXPECT_EQ(Run("--upgrade old.pbrt > new.pbrt").exitCode, 0);
    EXPECT_EQ(Run("new.pbrt --quiet").exitCode, 0) << Read("new.pbrt");
    EXPECT_EQ(Run("--format < new.pbrt > again.pbrt").exitCode, 0);
    EXPECT_EQ(Read("again.pbrt"), Read("new.pbrt"));
    EXPECT_EQ(Run("--toply again.pbrt > third.pbrt").exitCode, 0);
    EXPECT_EQ(Read("third.pbrt"), Read("new.pbrt"));
    const Outcome both = Run("--format --upgrade old.pbrt");
    EXPECT_EQ(both.exitCode, 1);
    EXPECT_NE(both.said.find("exclude each other"), std::string::npos) << both.said;
}

TEST_F(Program, PixelBoundsAndPng) {
    Write("scene.pbrt", kScene);
    EXPECT_EQ(Run("scene.pbrt --quiet --outfile a.png --pixelbounds 4,10,2,6").exitCode, 0);
    const auto image = ReadImage((folder / "a.png").string());
    ASSERT_TRUE(image) << image.error;
    EXPECT_EQ(image.value->Resolution(), (Point2i{6, 4}));
}

TEST_F(Program, ReadsStandardInput) {
    Write("scene.pbrt", kScene);
    EXPECT_EQ(Run("--quiet < scene.pbrt").exitCode, 0);
    EXPECT_EQ(Files(), std::vector<std::string>{"out.exr"});
}

TEST_F(Program, BrokenSceneWritesNothing) {
    Write("scene.pbrt", std::string(kScene) + "Shape \"spehre\"\n");
    const Outcome outcome = Run("scene.pbrt");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(
        outcome.said.find("scene.pbrt:6:1: unknown shape \"spehre\"; did you mean \"sphere\"?"),
        std::string::npos)
        << outcome.said;
    EXPECT_TRUE(Files().empty());
}

TEST_F(Program, UserMistakesOnTheCommandLine) {
    Write("scene.pbrt", kScene);
    const auto says = [&](const std::string &arguments, const std::string &what) {
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.exitCode, 1) << arguments;
        EXPECT_NE(outcome.said.find(what), std::string::npos) << arguments << ": " << outcome.said;
    };
    says("no-such-scene.pbrt", "no-such-scene.pbrt");
    says("scene.pbrt --ssp 4", "did you mean --spp?");
    says("scene.pbrt --spp", "--spp");
    says("scene.pbrt --spp many", "many");
    says("scene.pbrt --outfile picture.gif", ".exr");
    says("scene.pbrt --outfile no/such/folder/a.exr", "no/such/folder");
    says("scene.pbrt --cropwindow 0,1", "cropwindow");
    EXPECT_TRUE(Files().empty());
}

TEST_F(Program, HelpAndVersion) {
    const Outcome help = Run("--help");
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.said.find("--outfile"), std::string::npos);
    const Outcome version = Run("--version");
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_NE(version.said.find("pbrt-feather"), std::string::npos);
}

TEST_F(Program, InterruptedRenderLeavesTheOldFile) {
    Write("scene.pbrt", kScene);
    Write("out.exr", "the old picture");
    // Far too many samples to finish: the signal ends it.
    const Outcome outcome =
        Run("scene.pbrt --spp 16777216", "timeout --signal=INT --preserve-status 1");
    EXPECT_EQ(outcome.exitCode, 130) << outcome.said;
    EXPECT_NE(outcome.said.find("wrote out.partial.exr"), std::string::npos) << outcome.said;
    EXPECT_EQ(Read("out.exr"), "the old picture");
    EXPECT_EQ(Files(), (std::vector<std::string>{"out.exr", "out.partial.exr"}));
}

TEST_F(Program, StatsTellWhatWasDone) {
    Write("scene.pbrt", kScene);
    const Outcome outcome = Run("scene.pbrt --stats --nthreads 1");
    for (const char *what : {"Rays", "Memory", "Build", "Render"})
        EXPECT_NE(outcome.said.find(what), std::string::npos) << outcome.said;
}

TEST_F(Program, StatsFileIsJsonOfWhatWasDone) {
    Write("scene.pbrt", kScene);
    const Outcome outcome = Run("scene.pbrt --spp 4 --nthreads 1 --quiet --stats-file s.json");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
    const auto json = nlohmann::json::parse(Read("s.json"));
    for (const char *what : {"parseSeconds", "buildSeconds", "renderSeconds"})
        EXPECT_GE(json.at(what).get<double>(), 0) << what;
    EXPECT_EQ(json.at("cameraSamples"), 16 * 8 * 4);
    EXPECT_GE(json.at("closestHitRays"), json.at("cameraSamples"));
    EXPECT_GT(json.at("peakBytes"), json.at("traversalBytes"));
    EXPECT_GE(json.at("traversalPeakBytes"), json.at("traversalBytes"));
}

TEST_F(Program, StatsFileThatCannotBeWrittenIsToldBeforeRendering) {
    Write("scene.pbrt", kScene);
    const Outcome outcome = Run("scene.pbrt --stats-file no/such/folder/s.json");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.said.find("no/such/folder"), std::string::npos) << outcome.said;
    EXPECT_TRUE(Files().empty());
}

}  // namespace
}  // namespace pbrt
