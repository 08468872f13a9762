// Parameter lists as they stand after parsing; ParamDict's view of them is in param_dict_test.

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace pbrt {
namespace {

/// Parameters of a shape, and what was said.
std::unique_ptr<Parsed> ParseShape(const std::string &list) {
    return ParseWorld("Shape \"s\" " + list);
}

ParsedParameter Only(const Parsed &parsed) {
    EXPECT_EQ(parsed.Messages(), Texts{});
    EXPECT_EQ(All(parsed.scene.shapes).at(0).params.size(), 1u);
    return All(parsed.scene.shapes).at(0).params.at(0);
}

TEST(Parameters, FloatTypesFillFloats) {
    for (const char *type : {"float", "point2", "point3", "vector2", "vector3", "normal", "rgb",
                             "blackbody", "spectrum"}) {
        const auto parsed = ParseShape('"' + std::string(type) + " a\" [ 1 -2.5 0x1p-1 ]");
        const ParsedParameter p = Only(*parsed);
        EXPECT_EQ(p.type, type);
        EXPECT_EQ(p.name, "a");
        EXPECT_EQ(p.floats, (std::vector<float>{1, -2.5, .5}));
        EXPECT_TRUE(p.ints.empty() && p.strings.empty() && p.bools.empty());
    }
}

TEST(Parameters, OtherTypesFillTheirOwn) {
    EXPECT_EQ(Only(*ParseShape(R"("integer a" [ 1 -2 ])")).ints, (std::vector<int>{1, -2}));
    EXPECT_EQ(Only(*ParseShape(R"("bool a" [ true false ])")).bools, (std::vector<uint8_t>{1, 0}));
    EXPECT_EQ(Only(*ParseShape(R"("string a" [ "x" "float b" ])")).strings,
              (Texts{"x", "float b"}));
    EXPECT_EQ(Only(*ParseShape(R"("texture a" "t")")).strings, Texts{"t"});
    EXPECT_EQ(Only(*ParseShape(R"("spectrum a" "metal-Cu-k")")).strings, Texts{"metal-Cu-k"});
}

TEST(Parameters, ASingleValueNeedsNoBrackets) {
    EXPECT_EQ(Only(*ParseShape(R"("float a" 3)")).floats, std::vector<float>{3});
    EXPECT_EQ(Only(*ParseShape(R"("bool a" true)")).bools, std::vector<uint8_t>{1});
}

TEST(Parameters, BlanksInDeclarationsAreFree) {
    const auto parsed = ParseShape("\" \tfloat \t a  \" 1");
    EXPECT_EQ(Only(*parsed).type, "float");
    EXPECT_EQ(Only(*parsed).name, "a");
}

TEST(Parameters, KnowTheirPlaces) {
    const auto parsed = ParseShape("\"float a\"\n  [ 1 2 ] \"integer b\" 7");
    const ParsedParameters p = All(parsed->scene.shapes).at(0).params;
    ASSERT_EQ(p.size(), 2u);
    EXPECT_EQ(p[0].loc, (FileLoc{"test.pbrt", 2, 11}));
    EXPECT_EQ(p[0].valueLoc, (FileLoc{"test.pbrt", 3, 5}));
    EXPECT_EQ(p[1].loc, (FileLoc{"test.pbrt", 3, 11}));
    EXPECT_EQ(p[1].valueLoc, (FileLoc{"test.pbrt", 3, 23}));
}

/// A shape's parameters, and the message about them at a column of its line.
struct Wrong {
    const char *list, *message;
};

TEST(Parameters, EachMistakeIsReportedOnceAndReadingGoesOn) {
    const Wrong cases[] = {
        {R"("flaot a" 1)",
         R"(11: unknown parameter type "flaot" in "flaot a"; did you mean "float"?)"},
        {R"("color a" [ 1 2 3 ])",
         R"(11: unknown parameter type "color" in "color a"; pbrt-v4 calls it "rgb")"},
        {R"("normal3 a" [ 1 2 3 ])",
         R"(11: unknown parameter type "normal3" in "normal3 a"; pbrt-v4 calls it "normal")"},
        {R"("a" 1)", R"(11: expected a parameter declaration "type name", found "a")"},
        {R"("" 1)", R"(11: expected a parameter declaration "type name", found "")"},
        {R"("float a b" 1)",
         R"(11: expected a parameter declaration "type name", found "float a b")"},
        {R"("float a" [ ])", R"(23: "float a": the list is empty)"},
        {R"("float a" [ 1 x 2 ])", R"(25: "float a": "x" is not a number)"},
        {R"("float a" nan)", R"(21: "float a": "nan" is not a number)"},
        {R"("float a" 1e40)", R"(21: "float a": "1e40" is too large for a 32-bit float)"},
        {R"("float a" "1")", R"(21: "float a": expected a number, found the string "1")"},
        {R"("float a" true)", R"(21: "float a": "true" is not a number)"},
        {R"("float a" [ 1 "x" 2 ])",
         R"(25: "float a": expected a number or "]", found the string "x")"},
        {R"("float a" [ 1 [ 2 ] ])", R"(25: "float a": expected a number or "]", found "[")"},
        {R"("float a" 1 2 3)",
         R"(23: "float a": found a second value "2"; write several values in [ ])"},
        {R"("integer a" [ 1 1.5 ])", R"(27: "integer a": "1.5" is not an integer)"},
        {R"("integer a" 3000000000)",
         R"(23: "integer a": "3000000000" is too large for a 32-bit integer)"},
        {R"("bool a" "true")", R"(20: "bool a": write true without quotes)"},
        {R"("bool a" yes)", R"(20: "bool a": expected true or false, found "yes")"},
        {R"("bool a" 1)", R"(20: "bool a": expected true or false, found "1")"},
        {R"("string a" x)", R"(22: "string a": expected a quoted string, found "x")"},
        {R"("string a" [ "x" 1 ])",
         R"(28: "string a": expected a quoted string or "]", found "1")"},
        {R"("spectrum a" [ 400 "x" ])",
         R"(30: "spectrum a": expected a number or "]", found the string "x")"},
        {R"("spectrum a" [ "x" 400 ])",
         R"(30: "spectrum a": expected a quoted string or "]", found "400")"},
    };
    for (const Wrong &c : cases) {
        const auto parsed = ParseWorld("Shape \"s\" " + std::string(c.list) +
                                       " \"integer good\" 7\nShape \"next\"");
        EXPECT_EQ(parsed->Messages(), Texts{"test.pbrt:2:" + std::string(c.message)}) << c.list;
        ASSERT_EQ(parsed->scene.shapes.size(), 2u) << c.list;
        const ParsedParameters p = All(parsed->scene.shapes)[0].params;
        ASSERT_FALSE(p.empty()) << c.list;
        EXPECT_EQ(p.back().ints, std::vector<int>{7}) << c.list;
    }
}

TEST(Parameters, AWrongOneIsKeptWithoutValues) {
    const auto parsed = ParseShape(R"("float a" x)");
    ASSERT_EQ(All(parsed->scene.shapes).at(0).params.size(), 1u);
    EXPECT_TRUE(All(parsed->scene.shapes)[0].params[0].floats.empty());
}

TEST(Parameters, AMissingValueOrBracketDoesNotSwallowWhatFollows) {
    EXPECT_EQ(ParseShape("\"float a\"\nShape \"t\"")->Messages(),
              Texts{R"(test.pbrt:3:1: "float a": expected a number, found "Shape")"});
    EXPECT_EQ(ParseShape("\"float a\"")->Messages(),
              Texts{R"(test.pbrt:2:20: "float a": expected a number, found the end of the file)"});
    EXPECT_EQ(ParseShape("\"float a\" \"float b\" 1")->Messages(),
              Texts{R"(test.pbrt:2:21: "float a": expected a number, found the string "float b")"});
    const auto parsed = ParseShape("\"float a\" [ 1 2\n \"float b\" 1\nShape \"t\"");
    EXPECT_EQ(
        parsed->Messages(),
        Texts{R"(test.pbrt:3:2: "float a": expected a number or "]", found the string "float b")"});
    EXPECT_EQ(parsed->scene.shapes.size(), 2u);
    EXPECT_EQ(ParseShape("\"float a\" [ 1 2\nShape \"t\"")->scene.shapes.size(), 2u);
    EXPECT_EQ(
        ParseShape("\"float a\" [ 1 2")->Messages(),
        Texts{R"(test.pbrt:2:26: "float a": expected a number or "]", found the end of the file)"});
}

TEST(Parameters, AnUnclosedStringIsReportedOnce) {
    const auto parsed = ParseShape("\"string a\" \"x\n\"float b\" 1 \"float c\n2 \"float d\" 3");
    EXPECT_EQ(parsed->Messages(),
              (Texts{"test.pbrt:2:22: the string \"x\" is not closed before the end of its line",
                     "test.pbrt:3:13: the string \"float c\" is not closed before the end of its "
                     "line"}));
    EXPECT_EQ(All(parsed->scene.shapes).at(0).params.size(), 3u);
}

}  // namespace
}  // namespace pbrt
