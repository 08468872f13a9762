// The table of parameters: its ranges, its JSON form and what is said to those who err.

#include "pbrt/feathergen/parameters.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "grow_test.h"
#include "support/damaged.h"

namespace pbrt::feathergen {
namespace {

TEST(Parameters, TableIsSound) {
    std::set<std::string_view> names;
    for (const FloatParam &row : ParameterTable()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_LE(row.lo, row.def) << row.name;
        EXPECT_LE(row.def, row.hi) << row.name;
        EXPECT_FALSE(row.doc.empty()) << row.name;
    }
    // Each member is in the table: as many rows as there are doubles.
    EXPECT_EQ(sizeof(Parameters), names.size() * sizeof(double));
    for (const Preset &preset : Presets())
        for (const Preset::Change &change : preset.changes)
            for (const FloatParam &row : ParameterTable())
                EXPECT_TRUE(row.value != change.value ||
                            (change.to >= row.lo && change.to <= row.hi));
}

TEST(Parameters, JsonAndBack) {
    for (const Preset &preset : Presets()) {
        std::string problem;
        const Parameters parameters = PresetNamed(preset.name, &problem);
        EXPECT_EQ(problem, "");
        Parameters read;
        read.thickness = 1;
        EXPECT_EQ(FromJson(ToJson(parameters), &read), "");
        EXPECT_EQ(read, parameters) << preset.name;
    }
}

TEST(Parameters, JsonMistakes) {
    const Parameters before;
    Parameters p;
    EXPECT_EQ(FromJson(R"({"thickness": 600, "tilt": -20, "barb_count": 2.5, "spaceing": 1})", &p),
              "\"barb_count\" is 2.5, but it counts: expected a whole number\n"
              "unknown parameter \"spaceing\"; did you mean \"spacing\"?\n"
              "\"tilt\" is -20, outside [-1.57, 1.57] rad");
    EXPECT_EQ(FromJson(R"({"tilt": "steep"})", &p), "\"tilt\" is \"steep\": expected a number");
    EXPECT_EQ(FromJson("[1]", &p), "expected a JSON object { \"name\": number, ... }");
    EXPECT_NE(FromJson("{\"tilt\": ", &p).find("line 1"), std::string::npos);
    EXPECT_EQ(p, before) << "nothing is changed by what is refused";
}

using CommandLine = Grown;

TEST_F(CommandLine, PresetPrintedAndReadBackGrowsTheSameFeather) {
    Put("p.json", Succeed({"--preset", "rock-dove-purple", "--print-preset"}));
    Succeed({"--preset", "rock-dove-purple", "--seed", "3", "--out", Path("a")});
    Succeed({"--params", Path("p.json"), "--seed", "3", "--out", Path("b")});
    for (const char *name : {"feather-left.ply", "feather-rami.ply", "feather-thickness.exr"})
        EXPECT_EQ(Bytes(std::string("a/") + name), Bytes(std::string("b/") + name)) << name;
}

TEST_F(CommandLine, SeedDecides) {
    Succeed({"--seed", "1", "--out", Path("a")});
    Succeed({"--seed", "1", "--out", Path("b")});
    Succeed({"--seed", "2", "--out", Path("c")});
    for (const auto &entry : std::filesystem::directory_iterator(folder / "a")) {
        const std::string name = entry.path().filename().string();
        if (name == "feather.pbrt") continue;  // names its folder
        EXPECT_EQ(Bytes("a/" + name), Bytes("b/" + name)) << name;
        EXPECT_EQ(Bytes("a/" + name) == Bytes("c/" + name), name == "feather-rachis.ply") << name;
    }
}

TEST_F(CommandLine, MistakesNameTheOption) {
    const std::string out = Path("out");
    EXPECT_EQ(Fail({"--preset", "rock-dove-nek", "--out", out}),
              "feathergen: --preset: unknown preset \"rock-dove-nek\"; did you mean "
              "\"rock-dove-neck\"? Known: \"rock-dove-neck\", \"rock-dove-green\" or "
              "\"rock-dove-purple\"\n");
    EXPECT_EQ(Fail({"--set", "tilt=90", "--out", out}),
              "feathergen: --set: \"tilt\" is 90, outside [-1.57, 1.57] rad\n");
    EXPECT_EQ(Fail({"--set", "tilt", "--out", out}),
              "feathergen: --set: \"tilt\": expected name=number\n");
    EXPECT_EQ(Fail({"--seed", "1"}),
              "feathergen: --out is missing: expected a folder to write to\n");
    EXPECT_EQ(Fail({"--textures", "ptx", "--out", out}),
              "feathergen: --textures: unknown kind \"ptx\"; did you mean \"ptex\"? Known: "
              "\"atlas\" or \"ptex\"\n");
    EXPECT_NE(Fail({"--sead", "1", "--out", out}).find("did you mean"), std::string::npos);
    Put("p.json", "{\"spacing\": 0}");
    EXPECT_EQ(
        Fail({"--params", Path("p.json"), "--out", out}),
        "feathergen: --params: " + Path("p.json") + ": \"spacing\" is 0, outside [0.01, 10000]\n");
    EXPECT_NE(Fail({"neck", "--surface", Path("none.ply"), "--out", out}).find(Path("none.ply")),
              std::string::npos);
    EXPECT_NE(Fail({"neck", "--flow", "0,0,0", "--out", out}).find("no direction"),
              std::string::npos);
    EXPECT_EQ(Fail({"neck", "--set", "neck_spacing=0.1", "--set", "quads_along=2", "--out", out}),
              "feathergen: \"neck_spacing\" is 0.1 mm: more than 10000 feathers on this surface\n");
    EXPECT_EQ(Fail({"--set", "barb_count=2000", "--set", "quads_along=1000", "--out", out}),
              "feathergen: barb_count, quads_along and quads_across make 48000000 quads a feather, "
              "above 10000000\n");
    EXPECT_FALSE(std::filesystem::exists(out)) << "nothing is written after a mistake";
}

TEST_F(CommandLine, MessagesShowNoLongOrDeepValues) {
    const auto fail = [&](const std::string &json) {
        Put("p.json", json);
        return Fail({"--params", Path("p.json"), "--print-preset"});
    };
    const std::string before = "feathergen: --params: " + Path("p.json") + ": ";
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    EXPECT_EQ(fail("{\"jitter\": " + deep + "}"),
              before + "\"jitter\" is an array: expected a number\n");
    EXPECT_EQ(fail("{\"jitter\": {\"a\": 1}}"),
              before + "\"jitter\" is an object: expected a number\n");
    EXPECT_EQ(fail("{\"jitter\": \"much\"}"),
              before + "\"jitter\" is \"much\": expected a number\n");
    const std::string word(100000, 'x');
    for (const std::string &json :
         {"{\"jitter\": \"" + word + "\"}", "{\"" + word + "\": 1}", "{\"" + word + "\": []}",
          "{\"" + word, "{\"jitter\": " + std::string(100000, '[')})
        EXPECT_LT(fail(json).size(), before.size() + 300) << json.substr(0, 20);
    EXPECT_NE(fail(std::string(1000001, ' ')).find("more than 1.0 MB"), std::string::npos);
}

TEST_F(CommandLine, DamagedParametersAreReadOrRefused) {
    const std::string good = ToJson(Parameters());
    std::mt19937 random(6);
    for (int i = 0; i < 2000; ++i) {
        Parameters parameters;
        const std::string problem = FromJson(Damaged(good, random), &parameters);
        EXPECT_TRUE(problem.empty() || parameters == Parameters());
        for (const FloatParam &row : ParameterTable())
            EXPECT_TRUE(parameters.*row.value >= row.lo && parameters.*row.value <= row.hi);
    }
}

TEST_F(CommandLine, AllFilesOrNone) {
    std::filesystem::create_directories(folder / "out" / "feather-tilt.exr");  // in the way
    EXPECT_NE(Fail({"--out", Path("out")}).find("feather-tilt.exr"), std::string::npos);
    folder /= "out";
    EXPECT_EQ(FileCount(), 1u);
    folder = folder.parent_path();
}

TEST_F(CommandLine, HelpListsEveryParameter) {
    const std::string help = Succeed({"--help"});
    for (const FloatParam &row : ParameterTable())
        EXPECT_NE(help.find(row.name), std::string::npos) << row.name;
    EXPECT_NE(Succeed({"help", "neck"}).find("--surface"), std::string::npos);
}

}  // namespace
}  // namespace pbrt::feathergen
