#include "imgtool/tool_test.h"
#include "support/exr_parts.h"

namespace pbrt::imgtool {
namespace {

class ImgTool : public ToolTest {};

TEST_F(ImgTool, WithoutACommandItListsAll) {
    for (const std::vector<std::string> &args :
         {std::vector<std::string>{}, {"help"}, {"--help"}, {"-h"}}) {
        const std::string text = Succeed(args);
        for (const cli::Command &command : kTool.commands)
            EXPECT_NE(text.find(command.name), std::string::npos) << command.name;
    }
}

TEST_F(ImgTool, EveryCommandHasAManual) {
    for (const cli::Command &command : kTool.commands) {
        const std::string name(command.name);
        EXPECT_NE(Succeed({"help", name}).find("imgtool " + name), std::string::npos);
        EXPECT_EQ(Succeed({name, "--help"}), Succeed({"help", name}));
    }
}

TEST_F(ImgTool, MistakesAreExplained) {
    EXPECT_EQ(
        Fail({"convrt", "a.exr"}),
        "imgtool: unknown command \"convrt\"; did you mean \"convert\"?\nexpected "
        "\"assemble\", \"average\", \"bloom\", \"cat\", \"check\", \"convert\", \"denoise\", "
        "\"diff\", "
        "\"error\", \"falsecolor\", \"info\", \"makeequiarea\", \"merge\", \"scalenormalmap\", "
        "\"splitn\" or \"whitebalance\"\n");
    EXPECT_EQ(Fail({"convert", "a.exr", "--outfle", "b"}),
              "imgtool convert: unknown option --outfle; did you mean --outfile?\n"
              "(\"imgtool convert --help\" lists the options)\n");
    EXPECT_EQ(Fail({"diff", "a.exr"}),
              "imgtool diff: --reference is required\n"
              "(\"imgtool diff --help\" lists the options)\n");
    EXPECT_EQ(Fail({"info", Path("none.exr")}),
              "imgtool: " + Path("none.exr") + ": cannot be opened: No such file or directory\n");
}

TEST_F(ImgTool, EveryCommandSaysWhatOfAFileItDoesNotRead) {
    const std::string stereo = Path("stereo.exr"), out = Path("out.exr");
    WriteExrParts(stereo, {"left", "right"}, {4, 2});
    const std::string plain = Save("plain.exr", Picture({4, 2}, kRGB, std::vector<float>(24, 1)));
    const std::string other = Save("other.exr", Picture({4, 2}, kRGB, std::vector<float>(24, 3)));
    const std::string said =
        "imgtool: " + stereo +
        ": has 2 parts, of which only the first, \"left\", is read (others: \"right\")\n";
    const std::vector<std::vector<std::string>> commands{
        {"assemble", stereo, "--outfile", out},
        {"average", stereo, other, "--outfile", out},
        {"bloom", stereo, "--outfile", out},
        {"cat", stereo},
        {"check", stereo},
        {"convert", stereo, "--outfile", out},
        {"diff", stereo, "--reference", plain},
        {"error", plain, plain, "--reference", stereo},
        {"falsecolor", stereo, "--outfile", out},
        {"info", stereo},
        {"makeequiarea", stereo, "--outfile", out},
        {"scalenormalmap", stereo, "--outfile", out},
        {"splitn", stereo, plain, "--outfile", out},
        {"whitebalance", "--temperature", "5000", stereo, "--outfile", out}};
    // denoise needs its library; merge takes no such file.
    EXPECT_EQ(commands.size() + 2, kTool.commands.size());
    for (const std::vector<std::string> &args : commands) {
        const cli::Outcome outcome = Do(args);
        EXPECT_EQ(outcome.exitCode, 0) << args[0] << outcome.err;
        EXPECT_EQ(outcome.err, said) << args[0];
    }
}

TEST_F(ImgTool, InfoCountsWhatIsNotFinite) {
    Image image = Picture({2, 2}, {"Y"}, {1, NAN, -3, INFINITY});
    image.metadata.samplesPerPixel = 64;
    const std::string text = Succeed({"info", Save("a.exr", image)});
    EXPECT_NE(text.find("2 x 2 pixels, float"), std::string::npos) << text;
    EXPECT_NE(text.find("samples per pixel 64"), std::string::npos) << text;
    EXPECT_NE(text.find("-3            1           -1        1        1"), std::string::npos)
        << text;
}

TEST_F(ImgTool, CheckWantsFiniteBrightChangingPictures) {
    const std::string good =
        Save("good.exr", Picture({3, 1}, kRGB, {0.2f, 1, 0.2f, 1, 1, 1, 1, 0.2f, 1}));
    Succeed({"check", good});
    Succeed({"check", "--hue-change", "179", good});  // green to purple
    // A gray strip has no hue of its own.
    const std::string gray = Save("gray.exr", Picture({2, 1}, kRGB, {1, 1.01f, 1, 0.2f, 0.2f, 1}));
    EXPECT_NE(Fail({"check", "--hue-change", "10", gray})
                  .find("its hue changes by 0 degrees, less than 10"),
              std::string::npos);
    const std::string black = Save("black.exr", Image({2, 2}, kRGB));
    EXPECT_EQ(Fail({"check", black}), "imgtool: " + black + ": is black\n");
    const std::string nan = Save("nan.exr", Picture({1, 1}, kRGB, {1, NAN, 1}));
    EXPECT_EQ(Fail({"check", nan}), "imgtool: " + nan + ": has values that are not finite\n");
}

TEST_F(ImgTool, AverageAndItsVariance) {
    for (int i = 0; i < 4; ++i) {
        Image image = Picture({1, 1}, kRGB, {float(i), 2, 0});
        image.metadata.samplesPerPixel = 16;
        Save("seed-" + std::to_string(i) + ".exr", image);
    }
    Save("other.exr", Image({2, 2}, kRGB));
    Succeed({"average", Path("seed-"), "--outfile", Path("mean.exr"), "--variance-outfile",
             Path("variance.exr")});
    const Image mean = Load(Path("mean.exr")), variance = Load(Path("variance.exr"));
    EXPECT_EQ(mean.Data(), (std::vector<float>{1.5f, 2, 0}));
    EXPECT_EQ(mean.metadata.samplesPerPixel, 64);
    // Sample variance of 0 1 2 3 is 5/3; that of the mean of 4 is a quarter of it.
    EXPECT_FLOAT_EQ(variance.Data()[0], 5.f / 12);
    EXPECT_EQ(variance.Data()[1], 0);

    Succeed({"average", Path("seed-0.exr"), Path("seed-3.exr"), "--outfile", Path("mean.exr")});
    EXPECT_EQ(Load(Path("mean.exr")).Data(), (std::vector<float>{1.5f, 2, 0}));
}

TEST_F(ImgTool, AverageRefusesWhatHasNoMean) {
    Save("a-0.exr", Image({1, 1}, kRGB));
    const std::string other = Save("a-1.exr", Image({2, 1}, kRGB));
    EXPECT_EQ(Fail({"average", Path("a-"), "--outfile", Path("mean.exr")}),
              "imgtool: " + other + ": the pictures differ in size: 2 x 1 and 1 x 1 pixels\n");
    EXPECT_EQ(Fail({"average", Path("b-"), "--outfile", Path("mean.exr")}),
              "imgtool: " + Path("b-") + ": no such file, and none whose name begins so\n");
    EXPECT_EQ(Fail({"average", Path("a-0.exr"), "--outfile", Path("mean.exr"), "--varianceoutfile",
                    Path("v.exr")}),
              "imgtool: a variance needs two pictures at least\n");
    EXPECT_FALSE(std::filesystem::exists(Path("mean.exr")));
    const std::string nan = Save("nan.exr", Picture({1, 1}, kRGB, {1, NAN, 1}));
    EXPECT_EQ(Fail({"average", nan, "--outfile", Path("mean.exr")}),
              "imgtool: " + nan + ": has a value that is not a number\n");
    const Outcome infinite =
        Do({"average", Save("inf.exr", Picture({1, 1}, kRGB, {1, INFINITY, 1})), "--outfile",
            Path("mean.exr")});
    EXPECT_EQ(infinite.exitCode, 0);
    EXPECT_EQ(infinite.err, Path("inf.exr") + ": 1 infinite values count as 0\n");
}

TEST_F(ImgTool, ErrorDividesByTheNumberLessOne) {
    const std::string reference = Save("reference.exr", Image({1, 1}, kRGB));
    Save("seed-0.exr", Picture({1, 1}, kRGB, {1, 1, 1}));
    Save("seed-1.exr", Picture({1, 1}, kRGB, {3, 3, 3}));
    EXPECT_EQ(Succeed({"error", "--reference", reference, Path("seed-"), "--errorfile",
                       Path("error.exr")}),
              "MSE 10, from 2 pictures\n");
    EXPECT_EQ(Load(Path("error.exr")).Data(), (std::vector<float>{10, 10, 10}));
    EXPECT_EQ(Succeed({"error", "--reference", reference, "--metric", "mae", Path("seed-")}),
              "MAE 4, from 2 pictures\n");
    EXPECT_EQ(Fail({"error", "--reference", reference, Path("seed-0")}),
              "imgtool: error needs two pictures at least\n");
}

TEST_F(ImgTool, MakeEquiAreaTurnsTheSphere) {
    // A latitude-longitude picture of the direction itself, z up.
    Image latLong({256, 128}, kRGB);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) {
            const float theta = (y + 0.5f) / 128 * Pi, phi = (x + 0.5f) / 256 * 2 * Pi;
            const float d[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                std::cos(theta)};
            for (int c = 0; c < 3; ++c)
                latLong.Set({x, y}, c, d[c]);
        }
    Succeed({"makeequiarea", Save("latlong.exr", latLong), "--outfile", Path("square.exr"),
             "--resolution", "64"});
    const Image square = Load(Path("square.exr"));
    ASSERT_EQ(square.Resolution(), (Point2i{64, 64}));
    const auto expectDirection = [&](Point2i p, Vector3f d) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(square.Get(p, c), d[c], 0.05f) << p.x << ' ' << p.y;
    };
    expectDirection({32, 32}, {0, 0, 1});
    expectDirection({0, 0}, {0, 0, -1});
    expectDirection({63, 32}, {1, 0, 0});
    expectDirection({0, 31}, {-1, 0, 0});
    expectDirection({31, 63}, {0, 1, 0});
    // Equal areas: the mean over the square is that over the sphere.
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int i = 0; i < 64 * 64; ++i)
            sum += square.Data()[3 * i + c];
        EXPECT_NEAR(sum / (64 * 64), 0, 1e-3);
    }
    EXPECT_EQ(Fail({"makeequiarea", Path("square.exr"), "--outfile", Path("b.exr")}),
              "imgtool: " + Path("square.exr") +
                  ": has 64 x 64 pixels, not twice as many columns as rows\n");
}

}  // namespace
}  // namespace pbrt::imgtool
