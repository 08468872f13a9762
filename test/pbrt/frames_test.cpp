// Frames of a moving scene.

#include "pbrt/program.h"

namespace pbrt::test {
namespace {

class Frames : public ProgramFolder {
  protected:
    /// A sky of the brightness that `scale` says, and nothing else: pictures are proportional to
    /// it.
    void PutSky(const std::string &scale, const std::string &film = "") const {
        Put("sky.pbrt",
            "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" 4 " + film +
                "\nSampler \"independent\" \"integer pixelsamples\" 16\nWorldBegin # not $(this\n"
                "LightSource \"infinite\" \"float scale\" " +
                scale + "\n");
    }
    double Brightness(const std::string &name) const { return Load(name).Get({1, 1}, 1); }
};

/// The pictures' numbers have 11 bits.
constexpr double kHalfError = 0x1p-10;

TEST_F(Frames, PutTheirNumberIntoSceneAndName) {
    PutSky("$(2 * frame + 0.5)");
    Succeed("pbrt sky.pbrt --frames 1:3 --outfile 'sky-$frame.exr'");
    EXPECT_NEAR(Brightness("sky-2.exr") / Brightness("sky-1.exr"), 4.5 / 2.5, 2 * kHalfError);
    EXPECT_NEAR(Brightness("sky-3.exr") / Brightness("sky-1.exr"), 6.5 / 2.5, 3 * kHalfError);
    EXPECT_FALSE(IsThere("sky-0.exr") || IsThere("sky-4.exr"));
}

TEST_F(Frames, TakeTheirNameFromTheScene) {
    PutSky("$frame", "\"string filename\" \"f$(100 + frame).exr\"");
    Succeed("pbrt sky.pbrt --frames 7:8");
    EXPECT_NEAR(Brightness("f108.exr") / Brightness("f107.exr"), 8. / 7, 2 * kHalfError);
}

TEST_F(Frames, ThatExistAreSkipped) {
    PutSky("$frame");
    Put("sky-2.exr", "mine");
    const std::string said = Succeed("pbrt sky.pbrt --frames 1:3 --outfile 'sky-$frame.exr'");
    EXPECT_NE(said.find("frame 2: sky-2.exr is there\n"), std::string::npos) << said;
    EXPECT_EQ(Get("sky-2.exr"), "mine");
    EXPECT_TRUE(IsThere("sky-1.exr") && IsThere("sky-3.exr"));
}

TEST_F(Frames, MistakesAreExplained) {
    PutSky("$frame");
    Refuses("pbrt sky.pbrt --frames 1:2 --outfile sky.exr",
            "--frames: every frame would be written to sky.exr; put $frame into its name");
    for (const char *const text : {"1", "2:1", "a:b", "1:2:3"})
        Refuses(std::string("pbrt sky.pbrt --frames ") + text,
                "--frames: expected whole numbers first:last");
    Refuses("pbrt --frames 1:2 < sky.pbrt", "--frames reads the scene once for each frame");
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"$(frame * frame)", "it is not linear in frame"},
        {"$(1 / frame)", "it is not linear in frame"},
        {"$(frame / 0)", "it divides by 0"},
        {"$(2 + )", "a number or frame is missing"},
        {"$(2 + x)", "\"x\" is neither a number nor frame"},
        {"$(2 3)", "what is \"3\"?"},
        {"$((frame)", "a \")\" is missing"}};
    for (const auto &[expression, why] : wrong) {
        PutSky(expression);
        Refuses("pbrt sky.pbrt --frames 1:2 --outfile '$frame.exr'",
                "sky.pbrt: line 4: " + expression.substr(0, 8));
        Refuses("pbrt sky.pbrt --frames 1:2 --outfile '$frame.exr'", why);
    }
}

TEST_F(Frames, AStoppedOneIsResumed) {
    Put("s.pbrt",
        "Film \"rgb\" \"integer xresolution\" 64 \"integer yresolution\" 64\n"
        "Sampler \"independent\" \"integer pixelsamples\" 512\n"
        "LookAt 0 0 $(3 + frame / 10) 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\n"
        "WorldBegin\nLightSource \"infinite\"\nMaterial \"featherbarbule\"\nShape \"sphere\"\n");
    Succeed("pbrt --quiet s.pbrt --frames 1:3 --outfile 'right-$frame.exr'");
    const std::string frames = "pbrt s.pbrt --frames 1:3 --outfile 'f-$frame.exr' ";
    // In the second frame, as the first's picture is there.
    Succeed("cp right-1.exr f-1.exr");
    const Outcome stopped =
        Run("timeout --preserve-status -s TERM 0.4 " + frames + "--checkpoint f.ck,0");
    ASSERT_EQ(stopped.exitCode, 143) << stopped.said;
    ASSERT_TRUE(IsThere("f.ck"));
    Succeed(frames + "--resume f.ck");
    for (const char *const n : {"2", "3"})
        EXPECT_TRUE(Get(std::string("f-") + n + ".exr") == Get(std::string("right-") + n + ".exr"))
            << n;
    EXPECT_FALSE(IsThere("f.ck"));
}

}  // namespace
}  // namespace pbrt::test
