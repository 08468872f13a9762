// Options of all programs, as a user types them: lists before file names, ranges, `Option`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "pbrt/image/image.h"
#include "pbrt/scene/description.h"
#include "support/folders.h"
#include "support/shell.h"
#include "support/temp_folder.h"

namespace pbrt {
namespace {

class ProgramOptions : public TempFolder {
  protected:
    /// `command` begins with a program's name.
    Outcome Run(const std::string &command) {
        return Shell("cd '" + Path("") + "' && PATH='" + ProgramDir() + "':\"$PATH\" " + command);
    }
    void Write(const std::string &name, const std::string &text) {
        std::ofstream(Path(name)) << text;
    }
    Image Load(const std::string &name) {
        OrError<Image> image = ReadImage(Path(name));
        EXPECT_TRUE(image) << image.error;
        return image.value.value_or(Image({1, 1}, {"none"}));
    }
    void Says(const std::string &command, const std::string &what) {
        const Outcome outcome = Run(command);
        EXPECT_EQ(outcome.exitCode, 1) << command;
        EXPECT_NE(outcome.said.find(what), std::string::npos) << command << ": " << outcome.said;
    }
};

constexpr char kScene[] =
    "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 8 \"string filename\" "
    "\"out.exr\"\nSampler \"independent\" \"integer pixelsamples\" 2\nWorldBegin\n"
    "LightSource \"infinite\"\nTranslate 0 0 3 Shape \"sphere\"\n";

/// What every program and command can be asked for its options by.
const std::vector<std::string> kCommands{"pbrt",
                                         "imgtool assemble",
                                         "imgtool average",
                                         "imgtool check",
                                         "imgtool convert",
                                         "imgtool diff",
                                         "imgtool error",
                                         "imgtool info",
                                         "imgtool makeequiarea",
                                         "imgtool merge",
                                         "imgtool bloom",
                                         "imgtool cat",
                                         "imgtool denoise",
                                         "imgtool falsecolor",
                                         "imgtool scalenormalmap",
                                         "imgtool splitn",
                                         "imgtool whitebalance",
                                         "bsdftool eval",
                                         "bsdftool furnace",
                                         "bsdftool plot",
                                         "bsdftool spectrum",
                                         "feathergen",
                                         "feathergen neck"};

TEST_F(ProgramOptions, NoCommandIsForgottenHere) {
    for (const std::string tool : {"imgtool", "bsdftool"}) {
        const std::string help = Run(tool + " help").said;
        size_t count = 0;
        for (const std::string &command : kCommands)
            count += command.starts_with(tool + " ");
        const std::regex row("\n  [a-z]");
        EXPECT_EQ(std::distance(std::sregex_iterator(help.begin(), help.end(), row), {}),
                  ptrdiff_t(count))
            << help;
    }
}

TEST_F(ProgramOptions, ListsTakeNothingOfTheFileNamesBehindThem) {
    const std::regex list("\n  (--[a-z-]+) ([^ \n,]+(,[^ \n,]+)+)");
    const std::regex required("\n  (--[a-z-]+) [^\n]*required: ");
    int visited = 0;
    for (const std::string &command : kCommands) {
        const std::string help = Run(command + " --help").said;
        if (help.substr(0, help.find('\n')).ends_with("[options]")) continue;  // no file names
        std::string others;
        for (std::sregex_iterator i(help.begin(), help.end(), required), end; i != end; ++i)
            others.append(" ").append((*i)[1].str()).append(" other");
        for (std::sregex_iterator i(help.begin(), help.end(), list), end; i != end; ++i) {
            const std::string value = std::regex_replace((*i)[2].str(), std::regex("[^,]+"), "1");
            for (const char *const between : {" ", "="}) {
                // Two files, for splitn asks for them first.
                const Outcome outcome = Run(fmt::format("{}{} {}{}{} none-such none-such", command,
                                                        others, (*i)[1].str(), between, value));
                EXPECT_EQ(outcome.exitCode, 1);
                EXPECT_NE(outcome.said.find("none-such"), std::string::npos)
                    << command << ' ' << i->str() << ": " << outcome.said;
                EXPECT_EQ(outcome.said.find("required"), std::string::npos) << outcome.said;
            }
            ++visited;
        }
    }
    // pbrt has --cropwindow, --pixelbounds, --pixel and --checkpoint; bsdftool --thetas twice,
    // --phis, --light and --wavelengths; several commands of imgtool have --crop and --channels.
    EXPECT_EQ(visited, 21);
}

TEST_F(ProgramOptions, EveryProgramHasAVersion) {
    for (const std::string &command : kCommands) {
        const Outcome outcome = Run(command + " --version");
        EXPECT_EQ(outcome.exitCode, 0) << command;
        EXPECT_TRUE(outcome.said.starts_with("pbrt-feather ")) << command << ": " << outcome.said;
    }
    EXPECT_EQ(Run("imgtool --version").said, Run("pbrt --version").said);
}

TEST_F(ProgramOptions, HelpNamesTheProgram) {
    for (const std::string &command : kCommands)
        EXPECT_TRUE(Run(command + " --help").said.starts_with("usage: " + command + " [options]"));
}

TEST_F(ProgramOptions, NumbersOutsideTheirRangeAreExplained) {
    Write("scene.pbrt", kScene);
    const std::string spp = "--spp: expected a whole number from 1 to 16777216, found ";
    for (const char *value : {"abc", "0", "-1", "1.5", "2147483647", "99999999999", "1e30", "nan"})
        Says(std::string("pbrt scene.pbrt --spp ") + value, spp + value + "\n");
    Says("pbrt scene.pbrt --target-error nan",
         "--target-error: expected a number above 0, found nan\n");
    Says("pbrt scene.pbrt --target-error 0",
         "--target-error: expected a number above 0, found 0\n");
    Says("pbrt scene.pbrt --nthreads 99999999999",
         "--nthreads: expected a whole number above 0 and at most 2147483647, found 99999999999\n");
    Says("pbrt scene.pbrt --seed 1.5", "--seed: expected a whole number, found 1.5\n");
    Says("pbrt scene.pbrt --cropwindow nan,1,0,1",
         "--cropwindow: expected 4 numbers x0,x1,y0,y1, found nan,1,0,1\n");
    Says("pbrt scene.pbrt --cropwindow 0,1", "expected 4 numbers x0,x1,y0,y1, found 0,1\n");
    Says("pbrt scene.pbrt --pixel 0,99999999999", "expected 2 whole numbers x,y from 0 to 65535, ");
    Says("pbrt scene.pbrt --render-coord-sys wrld",
         "expected \"camera\", \"cameraworld\" or \"world\", found wrld; did you mean \"world\"?");
    Says("imgtool convert a.exr --outfile b.exr --gamma 0",
         "imgtool convert: --gamma: expected a number above 0, found 0\n");
    Says("imgtool convert a.exr --outfile b.exr --crop 0,1,0,9999999999",
         "--crop: expected 4 whole numbers x0,x1,y0,y1 from -16777216 to 16777216, found 0,1,");
    Says("imgtool convert a.exr --outfile b.exr --channels R,,B",
         "--channels: expected names such as R,G,B, found R,,B\n");
    EXPECT_EQ(Run("feathergen --print-preset --seed 18446744073709551615").exitCode, 0);
    Says("pbrt scene.pbrt --checkpoint ,5", "--checkpoint: expected a file, or a file and seconds");
    Says("pbrt scene.pbrt --checkpoint a.ck,soon",
         "--checkpoint: expected a file, or a file and seconds, as in half.ck,30, found a.ck,soon");
    Says("feathergen --out f --seed -1",
         "--seed: expected a whole number of at least 0, found -1\n");
}

TEST_F(ProgramOptions, OfAnOptionGivenTwiceTheLastCounts) {
    Write("scene.pbrt", kScene);
    EXPECT_EQ(Run("pbrt --quiet --quiet --spp 4 --spp 8 scene.pbrt --outfile a.exr "
                  "--outfile=b.exr --cropwindow 0,1,0,1 --cropwindow 0,0.5,0,1")
                  .exitCode,
              0);
    const Image image = Load("b.exr");
    EXPECT_EQ(image.metadata.samplesPerPixel, 8);
    EXPECT_EQ(image.Resolution(), (Point2i{8, 8}));
    EXPECT_FALSE(std::filesystem::exists(Path("a.exr")));
}

TEST_F(ProgramOptions, WholeNumbersMayHaveAnExponent) {
    Write("scene.pbrt", kScene);
    EXPECT_EQ(Run("pbrt --quiet --spp 1e1 --seed -1 scene.pbrt").exitCode, 0);
    EXPECT_EQ(Load("out.exr").metadata.samplesPerPixel, 10);
}

TEST_F(ProgramOptions, CropsBeyondThePictureAreClippedAndTwoOfThemToldOf) {
    Write("scene.pbrt", kScene);
    const Outcome outcome =
        Run("pbrt --cropwindow -1e30,1e30,0,0.5 --pixelbounds 0,1,0,1 scene.pbrt");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.said.find("--pixelbounds and --pixel have no effect: --cropwindow counts"),
              std::string::npos)
        << outcome.said;
    EXPECT_EQ(Load("out.exr").Resolution(), (Point2i{16, 4}));
    std::string both = kScene;
    both.insert(both.find('\n'),
                " \"integer pixelbounds\" [ 0 1 0 1 ] \"float cropwindow\" "
                "[ 0 0.5 0 1 ]");
    Write("scene.pbrt", both);
    EXPECT_NE(
        Run("pbrt scene.pbrt").said.find("\"pixelbounds\" has no effect: \"cropwindow\" counts"),
        std::string::npos);
    EXPECT_EQ(Load("out.exr").Resolution(), (Point2i{8, 8}));
    Says("pbrt scene.pbrt --pixel 1,1 --pixelbounds 0,2,0,2", " excludes --pixel");
}

TEST_F(ProgramOptions, AWrongOutfileIsTheOptionsFault) {
    Write("scene.pbrt", kScene);
    Says("pbrt scene.pbrt --outfile a.gif",
         "Error: --outfile: cannot write \"a.gif\": the name must end in .exr, .png or .pfm\n");
}

TEST_F(ProgramOptions, WhatPbrtHasAndIsNotBuiltHereIsNamed) {
    Says("pbrt --gpu scene.pbrt",
         "unknown option --gpu; pbrt-v4 has it; not built here. The processor renders, sixteen "
         "paths "
         "at a time: leave it out\n");
    Says("pbrt --log-utilization scene.pbrt",
         "unknown option --logutilization; pbrt-v4 has it; not built here. Use --stats\n");
    Says("imgtool makesky a.exr", "unknown command \"makesky\"; pbrt-v4 has it; not built here\n");
}

TEST_F(ProgramOptions, ThousandsOfMessagesAreCounted) {
    std::string broken = "WorldBegin\n";
    for (int i = 0; i < 200; ++i)
        broken += "Shape \"cube\"\n";
    Write("scene.pbrt", broken);
    const std::string said = Run("pbrt scene.pbrt").said;
    EXPECT_NE(said.find("scene.pbrt:51:1"), std::string::npos);
    EXPECT_EQ(said.find("scene.pbrt:52:1"), std::string::npos);
    EXPECT_NE(said.find("... and 150 more messages.\n200 errors;"), std::string::npos) << said;
}

TEST_F(ProgramOptions, WarningsThatAreLeftOutAreCounted) {
    std::string broken = "Option \"wavefront\" true\nWorldBegin\n";
    for (int i = 0; i < 50; ++i)
        broken += "Shape \"cube\"\n";
    Write("scene.pbrt", broken);
    EXPECT_NE(Run("pbrt scene.pbrt").said.find("... and 1 more messages.\n50 errors;"),
              std::string::npos);
    EXPECT_EQ(Run("pbrt --quiet scene.pbrt").said.find("more messages"), std::string::npos);
}

TEST_F(ProgramOptions, CompatibilityIsWhatTheProgramsSay) {
    const Outcome now =
        Run("bash '" + SourceDir() + "/scripts/compatibility.sh' '" + ProgramDir() + "'");
    EXPECT_EQ(now.exitCode, 0);
    std::stringstream file;
    file << std::ifstream(SourceDir() + "/docs/COMPATIBILITY.md").rdbuf();
    EXPECT_TRUE(now.said == file.str())
        << "scripts/compatibility.sh > docs/COMPATIBILITY.md brings it up to date";
}

/// A mirror before a floor with a picture on it, seen askew: each Option changes something.
constexpr char kManyThings[] =
    "LookAt 1 2 -5  0.3 0 0  0 1 0 Camera \"perspective\"\nFilm \"rgb\" \"integer xresolution\" 16 "
    "\"integer "
    "yresolution\" 16 \"string filename\" \"out.exr\" \"bool savefp16\" false\n"
    "Sampler \"independent\" \"integer pixelsamples\" 4\nWorldBegin\n"
    "LightSource \"infinite\"\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" "
    "\"t.exr\" \"string filter\" \"trilinear\" \"float uscale\" 50 \"float vscale\" 50\n"
    "Material \"diffuse\" \"texture reflectance\" \"t\"\n"
    "Shape \"bilinearmesh\" \"point3 P\" [ -9 -1 -9  9 -1 -9  -9 -1 9  9 -1 9 ]\n"
    "Material \"conductor\" Shape \"sphere\"\n";

TEST_F(ProgramOptions, EveryOptionDirectiveChangesSomethingOrWarns) {
    const std::string mse =
        "\"reference.exr\" Option \"msereferenceout\" \"mse.txt\" Option \"msereferenceimage\" "
        "\"reference.exr\"";
    const std::map<std::string_view, std::string> values{{"disablepixeljitter", "true"},
                                                         {"disablewavelengthjitter", "true"},
                                                         {"disabletexturefiltering", "true"},
                                                         {"forcediffuse", "true"},
                                                         {"seed", "7"},
                                                         {"rendercoordsys", "\"camera\""},
                                                         {"msereferenceimage", mse},
                                                         {"msereferenceout", mse},
                                                         {"displacementedgescale", "2"},
                                                         {"pixelstats", "true"},
                                                         {"wavefront", "true"}};
    Image checks({8, 8}, {"R", "G", "B"});
    for (size_t i = 0; i < checks.Data().size(); ++i)
        checks.Data()[i] = float(i % 5) / 5;
    ASSERT_EQ(WriteImage(checks, Path("t.exr"), ExrPixels::Float), std::nullopt);
    Write("scene.pbrt", kManyThings);
    ASSERT_EQ(Run("pbrt --quiet scene.pbrt --outfile reference.exr").exitCode, 0);
    const std::vector<float> before = Load("reference.exr").Data();
    for (const std::string_view name : OptionNames()) {
        ASSERT_TRUE(values.contains(name)) << "give this test a value of " << name;
        const std::string option = "Option \"" + std::string(name) + "\" " + values.at(name) + "\n";
        Write("scene.pbrt", option + kManyThings);
        std::filesystem::remove(Path("mse.txt"));
        std::filesystem::remove(Path("out-stats.exr"));
        const Outcome outcome = Run("pbrt scene.pbrt");
        EXPECT_EQ(outcome.exitCode, 0) << outcome.said;
        EXPECT_TRUE(outcome.said.find("has no effect") != std::string::npos ||
                    std::filesystem::exists(Path("out-stats.exr")) ||
                    std::filesystem::exists(Path("mse.txt")) || Load("out.exr").Data() != before)
            << option;
    }
}

TEST_F(ProgramOptions, FlagsDoWhatTheDirectivesDo) {
    Write("scene.pbrt", std::string("Option \"forcediffuse\" true\n") + kScene);
    ASSERT_EQ(Run("pbrt --quiet scene.pbrt --outfile a.exr").exitCode, 0);
    Write("scene.pbrt", kScene);
    ASSERT_EQ(Run("pbrt --quiet --force-diffuse scene.pbrt --mse-reference-image a.exr "
                  "--mse-reference-out mse.txt")
                  .exitCode,
              0);
    EXPECT_EQ(Load("out.exr").Data(), Load("a.exr").Data());
    std::ifstream file(Path("mse.txt"));
    std::string line;
    std::vector<std::string> lines;
    while (std::getline(file, line))
        lines.push_back(line);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_TRUE(lines[0].starts_with("1, ")) << lines[0];
    EXPECT_TRUE(lines[1].starts_with("2, ")) << lines[1];
    // The references are halves of values up to 1, so off by 2^-12 at most, squared; roundings of
    // floats are far below.
    EXPECT_LT(std::stod(lines[1].substr(3)), 0x1p-24 + 1e-12);
    Says("pbrt scene.pbrt --mse-reference-image a.exr",
         "\"msereferenceimage\" is given, so that \"msereferenceout\" must be");
    Says("pbrt scene.pbrt --mse-reference-image none.exr --mse-reference-out b.txt", "none.exr");
    Says("pbrt scene.pbrt --mse-reference-image a.exr --mse-reference-out no/b.txt", "no/b.txt");
    Says("pbrt scene.pbrt --mse-reference-image a.exr --mse-reference-out b.txt --target-error 1",
         "--target-error");
}

}  // namespace
}  // namespace pbrt
