#include "bsdftool/tool_test.h"

namespace pbrt::bsdftool {
namespace {

TEST_F(BsdfTool, WithoutACommandItListsAll) {
    for (const std::vector<std::string> &args : {std::vector<std::string>{}, {"help"}, {"-h"}}) {
        const std::string text = Succeed(args);
        for (const cli::Command &command : kTool.commands)
            EXPECT_NE(text.find(command.name), std::string::npos) << command.name;
    }
}

TEST_F(BsdfTool, EveryCommandHasAManual) {
    for (const cli::Command &command : kTool.commands) {
        const std::string name(command.name);
        EXPECT_NE(Succeed({"help", name}).find("bsdftool " + name), std::string::npos);
        EXPECT_EQ(Succeed({name, "--help"}), Succeed({"help", name}));
        EXPECT_NE(Fail({name}).find("bsdftool " + name + ": "), std::string::npos);
    }
}

TEST_F(BsdfTool, UnknownNamesComeWithTheNearest) {
    EXPECT_EQ(Fail({"furnice", kFeather}),
              "bsdftool: unknown command \"furnice\"; did you mean \"furnace\"?\nexpected "
              "\"eval\", \"furnace\", \"plot\" or \"spectrum\"\n");
    EXPECT_EQ(Fail({"furnace", kFeather, "--theta", "3"}),
              "bsdftool furnace: unknown option --theta; did you mean --thetas?\n"
              "(\"bsdftool furnace --help\" lists the options)\n");
    EXPECT_EQ(Fail({"furnace", "Material \"fetherbarbule\""}).substr(0, 86),
              "Error: <material>:1:1: unknown material \"fetherbarbule\"; did you mean "
              "\"featherbarbule\"");
}

TEST_F(BsdfTool, MistakesInAMaterialHaveAPlace) {
    EXPECT_EQ(Fail({"furnace", "Material \"featherbarbule\" \"float tilt\" -20"})
                  .find("Error: <material>:1:40: "),
              0u);
    EXPECT_EQ(Fail({"furnace", "Material \"diffuse\"\n  \"float albedo\" 1"})
                  .find("Error: <material>:2:3: "),
              0u);
    EXPECT_EQ(Fail({"furnace", "Shape \"sphere\""}),
              "Error: no material in \"Shape \"sphere\"\": give a directive such as 'Material "
              "\"featherbarbule\"', or a scene file\n");
    EXPECT_EQ(Fail({"furnace", "Material \"interface\""}),
              "Error: <material>:1:1: an interface scatters nothing\n");
}

TEST_F(BsdfTool, MaterialsComeFromSceneFilesToo) {
    Put("scene.pbrt",
        "Camera \"perspective\"\nWorldBegin\n"
        "MakeNamedMaterial \"first\" \"string type\" \"diffuse\" \"rgb reflectance\" [ 1 1 1 ]\n"
        "Material \"diffuse\" \"float nonsense\" 0\n"
        "Material \"featherbarbule\"\nShape \"sphere\"\n");
    Diagnostics log;
    const auto type = [&](const std::string &pick) {
        const auto source = ReadMaterial(Path("scene.pbrt"), pick, log);
        return source ? source->type : "";
    };
    EXPECT_EQ(type(""), "diffuse");
    EXPECT_EQ(type("first"), "diffuse");
    EXPECT_EQ(type("featherbarbule"), "featherbarbule");
    EXPECT_FALSE(log.HasErrors());
    EXPECT_EQ(type("frist"), "");
    ASSERT_EQ(log.Messages().size(), 1u);
    EXPECT_EQ(log.Messages()[0].text,
              "unknown material \"frist\"; did you mean \"first\"? Known: \"diffuse\", "
              "\"featherbarbule\" or \"first\"");
    EXPECT_EQ(Fail({"furnace", Path("none.pbrt")}),
              "Error: cannot read \"" + Path("none.pbrt") + "\": No such file or directory\n");
}

TEST_F(BsdfTool, ATextMayBeLongerThanAnyFileName) {
    std::string text = "Material \"featherbarbule\" \"spectrum melanin\" [";
    for (int lambda = 380; lambda <= 770; lambda += 10)
        text += std::to_string(lambda) + " .01 ";
    ASSERT_GT(text.size(), 255u);
    EXPECT_NE(Succeed({"spectrum", text + " ]", "--thetas", "0", "--samples", "16"}), "");
    // Beyond what a path may have, too, and without a blank.
    EXPECT_EQ(Fail({"furnace", std::string(10000, 'x')}).find("Error: cannot read \"xxx"), 0u);
    EXPECT_LT(Fail({"furnace", "Shape \"" + std::string(10000, 'x') + "\""}).size(), 300u);
}

TEST_F(BsdfTool, NaNIsNoNumberOfAnOption) {
    EXPECT_EQ(Fail({"spectrum", kFeather, "--step", "nan"}),
              "bsdftool spectrum: --step: expected a number from 0.1 to 50, found nan\n"
              "(\"bsdftool spectrum --help\" lists the options)\n");
    EXPECT_NE(Fail({"spectrum", kFeather, "--thetas", "nan"}), "");
}

TEST_F(BsdfTool, BadNumbersAndOutputsAreRefused) {
    EXPECT_EQ(Fail({"furnace", kFeather, "--thetas", "0,x"}),
              "Error: --thetas: \"x\" is not a number\n");
    EXPECT_EQ(Fail({"furnace", kFeather, "--thetas", "0,200"}),
              "Error: --thetas: 200 is outside [0, 180]\n");
    EXPECT_EQ(Fail({"spectrum", kFeather, "--thetas", ""}).find("bsdftool spectrum: "), 0u);
    EXPECT_NE(Fail({"furnace", kFeather, "--samples", "3"}).find("--samples"), std::string::npos);
    EXPECT_NE(Fail({"spectrum", kFeather, "--png", Path("no/such.png")}).find("no/such.png"),
              std::string::npos);
    EXPECT_NE(Fail({"spectrum", kFeather, "--illuminant", "stdillum-D66"})
                  .find("did you mean \"stdillum-D65\""),
              std::string::npos);
    EXPECT_EQ(Fail({"plot", kFeather}), "Error: nothing to do: give --png, --exr or both\n");
    EXPECT_EQ(Fail({"plot", kFeather, "--png", Path("a.png"), "--light", "30"}),
              "Error: --light: expected theta,phi in degrees, found \"30\"\n");
    EXPECT_EQ(Fail({"plot", kFeather, "--exr", Path("a.png")}),
              "Error: --exr: the name \"" + Path("a.png") + "\" does not end in .exr\n");
    EXPECT_EQ(FileCount(), 0u);
}

}  // namespace
}  // namespace pbrt::bsdftool
