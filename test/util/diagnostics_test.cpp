#include "pbrt/util/diagnostics.h"

#include <gtest/gtest.h>

#include <array>

namespace pbrt {
namespace {

TEST(Diagnostics, ShowsPlacesAsFarAsKnown) {
    Diagnostics log;
    log.Error({"a.pbrt", 3, 7}, "one");
    log.Warning({"a.pbrt", 0, 0}, "two");
    log.Error({}, "three");
    ASSERT_EQ(log.Messages().size(), 3u);
    EXPECT_EQ(log.Messages()[0].text, "a.pbrt:3:7: one");
    EXPECT_EQ(log.Messages()[1].text, "a.pbrt: two");
    EXPECT_EQ(log.Messages()[2].text, "three");
    EXPECT_EQ(log.Messages()[1].severity, Severity::Warning);
    EXPECT_EQ(log.ErrorCount(), 2);
}

TEST(Diagnostics, ImmediateRepetitionsAreOneMessage) {
    Diagnostics log;
    log.Error({}, "x");
    log.Error({}, "x");
    log.Error({}, "y");
    log.Error({}, "x");
    EXPECT_EQ(log.Messages().size(), 3u);
}

TEST(Diagnostics, WarnsOnceOfTheSameWhereverItIsMet) {
    Diagnostics log;
    log.WarningOnce({"a.pbrt", 3, 7}, "one");
    log.WarningOnce({"a.pbrt", 4, 7}, "two");
    log.WarningOnce({"a.pbrt", 5, 7}, "one");
    ASSERT_EQ(log.Messages().size(), 2u);
    EXPECT_EQ(log.Messages()[0].text, "a.pbrt:3:7: one");
    log.Warning({"a.pbrt", 6, 7}, "one");
    EXPECT_EQ(log.Messages().size(), 3u);
    EXPECT_EQ(log.ErrorCount(), 0);
}

TEST(Diagnostics, OrderOfPlaceIsThatOfFilesThenLines) {
    Diagnostics log;
    log.Error({"b.pbrt", 9, 1}, "4");
    log.Error({"a.pbrt", 2, 1}, "6");
    log.Error({"b.pbrt", 3, 7}, "3");
    log.Error({"b.pbrt", 3, 2}, "2");
    log.Error({"a.pbrt", 0, 0}, "5");
    log.Error({}, "1");
    std::string order;
    for (const Message *m : log.InOrderOfPlace())
        order += m->text.back();
    EXPECT_EQ(order, "123456");
}

TEST(Diagnostics, MissingFilesAreCountedByFolder) {
    Diagnostics log;
    for (int i = 0; i < 30; ++i) {
        const FileLoc loc{"a.pbrt", i + 1, 3};
        log.MissingFile(loc, "meshes/" + std::to_string(i) + ".ply", "/scenes");
        log.Error(loc, "what follows from it");
        log.Error({"a.pbrt", 100 + i, 3}, "something else");
    }
    log.MissingFile({"a.pbrt", 50, 3}, "meshes/0.ply", "/scenes");
    EXPECT_EQ(log.Messages().size(), 20u + 30u);
    EXPECT_EQ(log.Messages()[0].text, "a.pbrt:1:3: there is no file \"meshes/0.ply\"");
    log.MissingFile({"a.pbrt", 51, 3}, "/elsewhere/x.png", "/scenes");
    const std::vector<std::string> lines = log.MissingFiles();
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "1 file of /elsewhere/ is missing; looked for in /elsewhere/");
    EXPECT_EQ(lines[1].find("30 files of meshes/ are missing; looked for in /scenes/meshes/ and /"),
              0u);
}

TEST(Diagnostics, LongMessagesLoseTheirMiddle) {
    Diagnostics log;
    log.Error({"a.pbrt", 3, 7}, "begin " + std::string(1 << 20, 'x') + " end");
    const std::string &text = log.Messages()[0].text;
    EXPECT_TRUE(text.starts_with("a.pbrt:3:7: begin xxx") && text.ends_with("xxx end")) << text;
    EXPECT_LE(text.size(), 2000u);
}

TEST(Diagnostics, NothingInAMessageSteersATerminal) {
    Diagnostics log;
    log.Error({"a\033[2J.pbrt", 1, 1}, "\a\033]0;title\a is no name\nexpected one");
    EXPECT_EQ(log.Messages()[0].text, "a?[2J.pbrt:1:1: ??]0;title? is no name\nexpected one");
}

TEST(Shortened, KeepsBothEnds) {
    EXPECT_EQ(Shortened("abc", 3), "abc");
    EXPECT_EQ(Shortened("0123456789abcdef", 15), "01234 ... bcdef");
    EXPECT_EQ(Shortened(std::string(100, 'x')).size(), 59u);
    EXPECT_EQ(Shortened("abcdefgh", 2), " ... ");
}

TEST(NearestName, LongNamesAreNotCompared) {
    constexpr std::array<std::string_view, 1> kNames{"float"};
    EXPECT_EQ(NearestName("float" + std::string(1 << 24, 't'), kNames), "");
}

TEST(NearestName, CountsEditsAndSwapsOfNeighbours) {
    constexpr std::array<std::string_view, 4> kNames{"float", "roughness", "Film", "seed"};
    EXPECT_EQ(NearestName("flot", kNames), "float");
    EXPECT_EQ(NearestName("flaot", kNames), "float");
    EXPECT_EQ(NearestName("rougness", kNames), "roughness");
    EXPECT_EQ(NearestName("Flim", kNames), "Film");
    EXPECT_EQ(NearestName("sede", kNames), "seed");
    EXPECT_EQ(NearestName("FLOAT", kNames), "float");
    EXPECT_EQ(NearestName("fl", kNames), "");
    EXPECT_EQ(NearestName("", kNames), "");
    EXPECT_EQ(NearestName("integer", kNames), "");
}

TEST(NearestName, ListsAndHints) {
    constexpr std::array<std::string_view, 3> kNames{"a", "b", "c"};
    EXPECT_EQ(QuotedList(kNames), "\"a\", \"b\" or \"c\"");
    constexpr std::array<std::string_view, 1> kOne{"world"};
    EXPECT_EQ(QuotedList(kOne), "\"world\"");
    EXPECT_EQ(DidYouMean("wolrd", kOne), "; did you mean \"world\"?");
    EXPECT_EQ(DidYouMean("camera", kOne), "");
}

}  // namespace
}  // namespace pbrt
