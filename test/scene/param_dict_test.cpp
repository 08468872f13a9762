// What plug-ins read through ParamDict.

#include <gtest/gtest.h>

#include <array>

#include "scene/parse.h"
#include "support/folders.h"

namespace pbrt {
namespace {

/// The parameters of `material "m"` after some Attribute ones, and what was said.
class Dict {
  public:
    explicit Dict(const std::string &own, const std::string &inherited = "")
        : parsed(
              Parse("Attribute \"material\" " + inherited + " WorldBegin\nMaterial \"m\"\n" + own)),
          material(All(parsed->scene.materials).at(0)),
          dict(material.params, material.loc, "material \"m\"", material.colorSpace, &parsed->log) {
        EXPECT_EQ(parsed->Messages(), Texts{}) << own;
    }
    ParamDict *operator->() { return &dict; }
    Texts Messages() const { return parsed->Messages(); }

  private:
    std::unique_ptr<Parsed> parsed;
    Entity material;
    ParamDict dict;
};

// Rows as plug-ins have them.

constexpr FloatParam F(std::string_view name, float def = 0) {
    return {name, "", def, -kOpen, kOpen, "a number"};
}
constexpr IntParam I(std::string_view name, int def = 0) {
    return {name, def, kLeastInt, kMostInt, "a count"};
}
constexpr BoolParam B(std::string_view name, bool def = false) {
    return {name, def, "a switch"};
}
constexpr StringParam S(std::string_view name, std::string_view def = "") {
    return {name, def, "a word"};
}
constexpr PointParam P(std::string_view name, std::string_view type,
                       std::array<float, 3> def = {}) {
    return {name, type, def, "a place"};
}
constexpr SpectrumParam L(std::string_view name, SpectrumType role = SpectrumType::Illuminant) {
    return {name, role, "", "a color"};
}
constexpr ArrayParam List(std::string_view name, std::string_view type) {
    return {name, type, "none", "values"};
}

TEST(ParamDict, SingleValues) {
    Dict d(R"("float f" 1.5 "integer i" 2 "bool b" true "string s" "x"
              "point3 p3" [ 1 2 3 ] "vector3 v3" [ 4 5 6 ] "texture t" "wood")");
    EXPECT_EQ(d->GetOneFloat(F("f", 0)), 1.5f);
    EXPECT_EQ(d->GetOneInt(I("i", 0)), 2);
    EXPECT_TRUE(d->GetOneBool(B("b", false)));
    EXPECT_EQ(d->GetOneString(S("s", "")), "x");
    EXPECT_EQ(d->GetOnePoint3f(P("p3", "point3")), (Point3f{1, 2, 3}));
    EXPECT_EQ(d->GetOneVector3f(P("v3", "vector3")), (Vector3f{4, 5, 6}));
    EXPECT_EQ(d->GetTexture(F("t")), "wood");
    d->ReportUnused();
    EXPECT_EQ(d.Messages(), Texts{});
}

TEST(ParamDict, DefaultsWhereNothingIsGiven) {
    Dict d("");
    EXPECT_EQ(d->GetOneFloat(F("f", 7)), 7);
    EXPECT_EQ(d->GetOneFloat({"f", "", 7, 0, 10, ""}), 7);
    EXPECT_EQ(d->GetOneInt(I("i", 7)), 7);
    EXPECT_EQ(d->GetOneInt(IntParam{"i", 7, 0, 10, ""}), 7);
    EXPECT_TRUE(d->GetOneBool(B("b", true)));
    EXPECT_EQ(d->GetOneString(S("s", "def")), "def");
    EXPECT_EQ(d->GetOnePoint3f(P("p", "point3", {1, 2, 3})), (Point3f{1, 2, 3}));
    EXPECT_EQ(d->GetOneVector3f(P("p", "vector3", {1, 2, 3})), (Vector3f{1, 2, 3}));
    EXPECT_FALSE(d->GetOneSpectrum(L("L", SpectrumType::Illuminant)));
    EXPECT_FALSE(d->GetOneRGB(L("L")));
    EXPECT_FALSE(d->GetTexture(F("t")));
    EXPECT_EQ(d->GetFileName(S("filename")), "");
    EXPECT_TRUE(d->GetFloatArray(List("a", "float")).empty());
    EXPECT_TRUE(d->GetPoint3fArray(List("a", "point3")).empty());
    EXPECT_EQ(d->Loc("f"), d->Directive());
    d->ReportUnused();
    EXPECT_EQ(d.Messages(), Texts{});
}

TEST(ParamDict, Arrays) {
    Dict d(R"("float f" [ 1 2 ] "integer i" [ 1 2 3 ] "string s" [ "a" "b" ]
              "point2 p2" [ 1 2 3 4 ] "point3 p3" [ 1 2 3 4 5 6 ] "vector3 v" [ 1 2 3 ]
              "normal n" [ 0 0 1 ])");
    EXPECT_EQ(d->GetFloatArray(List("f", "float")), (std::vector<float>{1, 2}));
    EXPECT_EQ(d->GetIntArray(List("i", "integer")), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(d->GetStringArray(List("s", "string")), (Texts{"a", "b"}));
    EXPECT_EQ(d->GetPoint2fArray(List("p2", "point2")), (std::vector<Point2f>{{1, 2}, {3, 4}}));
    EXPECT_EQ(d->GetPoint3fArray(List("p3", "point3")),
              (std::vector<Point3f>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(d->GetVector3fArray(List("v", "vector3")), (std::vector<Vector3f>{{1, 2, 3}}));
    EXPECT_EQ(d->GetNormalArray(List("n", "normal")), (std::vector<Normal3f>{{0, 0, 1}}));
    d->ReportUnused();
    EXPECT_EQ(d.Messages(), Texts{});
}

TEST(ParamDict, WrongCountsAreErrorsAndTheDefaultCounts) {
    Dict d(R"("float f" [ 1 2 ] "point3 p" [ 1 2 ] "string s" [ "a" "b" ] "point3 P" [ 1 2 3 4 ])");
    EXPECT_EQ(d->GetOneFloat(F("f", 7)), 7);
    EXPECT_EQ(d->GetOnePoint3f(P("p", "point3", {7, 7, 7})), (Point3f{7, 7, 7}));
    EXPECT_EQ(d->GetOneString(S("s", "def")), "def");
    EXPECT_EQ(d->GetPoint3fArray(List("P", "point3")).size(), 1u);
    EXPECT_EQ(d.Messages(),
              (Texts{R"(test.pbrt:3:13: "float f": expected 1 value, found 2)",
                     R"(test.pbrt:3:32: "point3 p": expected 3 values, found 2)",
                     R"(test.pbrt:3:51: "string s": expected 1 value, found 2)",
                     R"(test.pbrt:3:74: "point3 P": 4 numbers are not a multiple of 3)"}));
}

TEST(ParamDict, RangesAreClosedAndNameTheUnit) {
    constexpr FloatParam kFov{"fov", "deg", 90, 1, 179, ""};
    constexpr FloatParam kRadius{"radius", "mm", 1, 0, Infinity, ""};
    constexpr FloatParam kGain{"gain", "", 1, -Infinity, 2, ""};
    Dict inside(R"("float fov" 179 "float radius" 0 "float gain" -5)");
    EXPECT_EQ(inside->GetOneFloat(kFov), 179);
    EXPECT_EQ(inside->GetOneFloat(kRadius), 0);
    EXPECT_EQ(inside->GetOneFloat(kGain), -5);
    EXPECT_EQ(inside.Messages(), Texts{});
    Dict none(R"("float width" 0)");
    EXPECT_EQ(none->GetOneFloat({"width", "", 1, kAboveZero, kOpen, ""}), 1);
    EXPECT_EQ(none->GetOneFloat({"width", "deg", 1, kAboveZero, 360, ""}), 1);
    EXPECT_EQ(none.Messages(),
              (Texts{R"(test.pbrt:3:15: "float width": 0 is not more than 0)",
                     R"(test.pbrt:3:15: "float width": 0 is outside (0, 360] deg)"}));
    Dict outside(R"("float fov" 200 "float radius" -0.5 "float gain" 3 "integer n" 0)");
    EXPECT_EQ(outside->GetOneFloat(kFov), 90);
    EXPECT_EQ(outside->GetOneFloat(kRadius), 1);
    EXPECT_EQ(outside->GetOneFloat(kGain), 1);
    EXPECT_EQ(outside->GetOneInt(IntParam{"n", 16, 1, 65536, ""}), 16);
    EXPECT_EQ(outside->GetOneInt(IntParam{"n", 16, 1, kMostInt, ""}), 16);
    EXPECT_EQ(outside.Messages(),
              (Texts{R"(test.pbrt:3:13: "float fov": 200 is outside [1, 179] deg)",
                     R"(test.pbrt:3:32: "float radius": -0.5 is less than 0 mm)",
                     R"(test.pbrt:3:50: "float gain": 3 is more than 2)",
                     R"(test.pbrt:3:64: "integer n": 0 is outside [1, 65536])",
                     R"(test.pbrt:3:64: "integer n": 0 is less than 1)"}));
}

TEST(ParamDict, ChoicesAreIndices) {
    constexpr std::array<std::string_view, 3> kTypes{"flat", "cylinder", "ribbon"};
    EXPECT_EQ(Dict("")->GetOneChoice({"type", "cylinder", kTypes, "a kind"}), 1);
    EXPECT_EQ(Dict("\"string type\" \"ribbon\"")->GetOneChoice({"type", "flat", kTypes, "a kind"}),
              2);
    Dict wrong("\"string type\" \"cylindr\"");
    EXPECT_EQ(wrong->GetOneChoice({"type", "flat", kTypes, "a kind"}), 0);
    EXPECT_EQ(wrong.Messages(),
              Texts{R"(test.pbrt:3:15: "string type": "cylindr" is not one of )"
                    R"("flat", "cylinder" or "ribbon"; did you mean "cylinder"?)"});
}

TEST(ParamDict, LaterDuplicatesOverrideSilently) {
    Dict d(R"("float f" 1 "float f" 2 "float f" 3)");
    EXPECT_EQ(d->GetOneFloat(F("f", 0)), 3);
    EXPECT_EQ(d->Loc("f").column, 25);
    d->ReportUnused();
    EXPECT_EQ(d.Messages(), Texts{});
}

TEST(ParamDict, OwnParametersComeBeforeInheritedOnes) {
    Dict d(R"("float f" 1)", R"("float f" 5 "float f" 6 "float g" 7 "float g" 8 "float h" 9)");
    EXPECT_EQ(d->GetOneFloat(F("f", 0)), 1);
    EXPECT_EQ(d->GetOneFloat(F("g", 0)), 8);  // the latest of the inherited
    d->ReportUnused();                        // h is inherited
    EXPECT_EQ(d.Messages(), Texts{});
}

TEST(ParamDict, AWrongTypeIsInvisible) {
    Dict d(R"("integer fov" 40)");
    EXPECT_EQ(d->GetOneFloat(F("fov", 90)), 90);
    d->ReportUnused();
    EXPECT_EQ(d.Messages(), Texts{R"(test.pbrt:3:1: "integer fov": expected "float fov")"});
}

TEST(ParamDict, WrongTypesListAllThatWouldDo) {
    Dict d(R"("float reflectance" 1)");
    EXPECT_FALSE(d->GetTexture(L("reflectance")));
    EXPECT_FALSE(d->GetOneSpectrum(L("reflectance", SpectrumType::Albedo)));
    d->ReportUnused();
    EXPECT_EQ(d.Messages(),
              Texts{R"(test.pbrt:3:1: "float reflectance": expected "texture reflectance", )"
                    R"("rgb reflectance", "spectrum reflectance" or "blackbody reflectance")"});
}

TEST(ParamDict, UnknownNamesListTheKnownAndTheNearest) {
    Dict d(R"("float rougness" 1 "string xyzzy" "a")");
    d->GetOneFloat(F("roughness", 0));
    d->GetOneBool(B("remaproughness", true));
    d->GetTexture(F("roughness"));
    d->ReportUnused();
    EXPECT_EQ(d.Messages(),
              (Texts{R"(test.pbrt:3:1: unknown parameter "float rougness" of material "m"; )"
                     R"(did you mean "roughness"? known: roughness, remaproughness)",
                     R"(test.pbrt:3:20: unknown parameter "string xyzzy" of material "m"; )"
                     R"(known: roughness, remaproughness)"}));
    Dict none(R"("float x" 1)");
    none->ReportUnused();
    EXPECT_EQ(
        none.Messages(),
        Texts{R"(test.pbrt:3:1: unknown parameter "float x" of material "m", which takes none)"});
}

TEST(ParamDict, KnownButOverriddenByAnotherType) {
    Dict d(R"("rgb L" [ 1 1 1 ] "blackbody L" 5000)");
    EXPECT_TRUE(d->GetOneSpectrum(L("L", SpectrumType::Illuminant)));
    d->ReportUnused();
    EXPECT_EQ(d.Messages(),
              Texts{R"(test.pbrt:3:1: "rgb L" has no effect: the later "blackbody L" counts)"});
}

TEST(ParamDict, KnownButNotRead) {
    Dict d(R"("float power" 1)");
    EXPECT_TRUE(d->Has(F("power")));
    d->ReportUnused();
    EXPECT_EQ(d.Messages(), Texts{R"(test.pbrt:3:1: "float power" has no effect here)"});
}

TEST(ParamDict, HasLooksWithoutReading) {
    Dict d(R"("float f" 1)", R"("rgb g" [ 1 1 1 ])");
    EXPECT_TRUE(d->Has(F("f")));
    EXPECT_TRUE(d->HasOrTexture(F("f")));
    EXPECT_FALSE(d->Has(I("f")));
    EXPECT_TRUE(d->IsNamed("f"));
    EXPECT_FALSE(d->IsNamed("h"));
    EXPECT_TRUE(d->Has(L("g")));
    EXPECT_FALSE(d->HasOrTexture(L("h")));
    Dict textured(R"("texture f" "t")");
    EXPECT_FALSE(textured->Has(F("f")));
    EXPECT_TRUE(textured->HasOrTexture(F("f")));
}

TEST(ParamDict, ALaterConstantOverridesATexture) {
    Dict constantLast(R"("texture r" "t" "rgb r" [ 1 0 0 ])");
    EXPECT_FALSE(constantLast->GetTexture(L("r")));
    EXPECT_EQ(constantLast->GetOneRGB(L("r")), (RGB{1, 0, 0}));
    Dict textureLast(R"("rgb r" [ 1 0 0 ] "texture r" "t")");
    EXPECT_EQ(textureLast->GetTexture(L("r")), "t");
    Dict own(R"("float r" 1)", R"("texture r" "t")");
    EXPECT_FALSE(own->GetTexture(F("r")));
    EXPECT_EQ(own->GetOneFloat(F("r", 0)), 1);
    own->ReportUnused();
    EXPECT_EQ(own.Messages(), Texts{});
}

TEST(ParamDict, RemembersWhatWasAskedEachOnceInOrder) {
    Dict d(R"("float eta" 1)");
    d->GetTexture(F("roughness", 3));
    d->Has(F("eta"));
    d->GetOneInt(I("n"));
    d->GetOneFloat(F("eta", 9));
    d->GetOneSpectrum(L("eta"));
    d->GetOneFloat(F("roughness", 4));
    d->GetPoint3fArray(List("P", "point3"));
    const std::vector<RequestedParam> &rows = d->Requested();
    ASSERT_EQ(rows.size(), 5u);
    const auto told = [&](size_t i) {
        return std::string(NameOf(rows[i].row)) + ": " + TypesOf(rows[i]) + " " +
               DefaultOf(rows[i].row);
    };
    EXPECT_EQ(told(0), "roughness: float or texture 3");
    EXPECT_EQ(told(1), "eta: float 0");
    EXPECT_EQ(told(2), "eta: rgb, spectrum or blackbody ");
    EXPECT_EQ(told(3), "n: integer 0");
    EXPECT_EQ(told(4), "P: point3 none");
}

TEST(ParamRow, RangesAndDefaultsAreShown) {
    constexpr std::array<std::string_view, 2> kWords{"a", "b"};
    EXPECT_EQ(RangeOf(F("f")), "");
    EXPECT_EQ(RangeOf(I("i")), "");
    EXPECT_EQ(RangeOf(FloatParam{"f", "nm", 1, 0, kOpen, ""}), ">= 0");
    EXPECT_EQ(RangeOf(FloatParam{"f", "nm", 1, -kOpen, 2, ""}), "<= 2");
    EXPECT_EQ(RangeOf(FloatParam{"f", "nm", 1, kAboveZero, kOpen, ""}), "> 0");
    EXPECT_EQ(RangeOf(FloatParam{"f", "nm", 1, kAboveZero, 2, ""}), "(0, 2]");
    EXPECT_EQ(RangeOf(IntParam{"i", 1, 0, 2, ""}), "[0, 2]");
    EXPECT_EQ(RangeOf(L("s")), ">= 0");
    EXPECT_EQ(RangeOf(L("s", SpectrumType::Albedo)), "[0, 1]");
    EXPECT_EQ(RangeOf(ChoiceParam{"c", "a", kWords, ""}), "a, b");
    EXPECT_EQ(DefaultOf(ChoiceParam{"c", "a", kWords, ""}), "\"a\"");
    EXPECT_EQ(DefaultOf(S("s")), "");
    EXPECT_EQ(DefaultOf(B("b", true)), "true");
    EXPECT_EQ(DefaultOf(P("p", "point3", {0, 1, 0.5f})), "0 1 0.5");
    EXPECT_EQ(UnitOf(FloatParam{"f", "nm", 1, 0, 2, ""}), "nm");
}

TEST(ParamDict, FileNamesStartFromTheScenesFolder) {
    const auto parsed = ParseWorld(
        "Material \"m\" \"string filename\" \"param_dict_test.cpp\" "
        "\"string other\" \"none.exr\" \"string absolute\" \"/x\"");
    const std::string dir = SourceDir() + "/test/scene";
    const Entity m = All(parsed->scene.materials).at(0);
    ParamDict d(m.params, m.loc, "material \"m\"", m.colorSpace, &parsed->log, dir);
    EXPECT_EQ(d.GetFileName(S("filename")), dir + "/param_dict_test.cpp");
    EXPECT_EQ(d.GetFileName(S("other")), "none.exr");
    EXPECT_EQ(d.GetFileName(S("absolute")), "/x");
}

TEST(ParamDict, ErrorsOfPlugInsStandAtTheParameter) {
    Dict d("\"float f\" 1");
    d->Error("f", "one");
    d->Error("g", "two");
    d->Error("three");
    d->Warning("f", "four");
    EXPECT_EQ(d.Messages(), (Texts{"test.pbrt:3:1: one", "test.pbrt:2:1: two",
                                   "test.pbrt:2:1: three", "test.pbrt:3:1: four"}));
}

TEST(ParamDict, MayOwnItsParameters) {
    ParsedParameter p;
    p.type = "float", p.name = "f", p.floats = {3};
    Diagnostics log;
    ParamDict moved(ParsedParameters{p}, {"f", 1, 1}, "x", nullptr, &log);
    ParamDict copy = moved;
    EXPECT_EQ(copy.GetOneFloat(F("f", 0)), 3);
    copy.ReportUnused();
    EXPECT_FALSE(log.HasErrors());
    moved.ReportUnused();  // what the copy read is its own affair
    EXPECT_TRUE(log.HasErrors());
}

TEST(ParamDict, WhatTheParserRefusedIsNotReportedAgain) {
    const auto parsed =
        ParseWorld(R"(Material "m" "float f" x "point3 P" [ 1 2 x ] "rgb c" [ x ])");
    EXPECT_EQ(parsed->Messages().size(), 3u);
    const Entity m = All(parsed->scene.materials).at(0);
    ParamDict d(m.params, m.loc, "material \"m\"", m.colorSpace, &parsed->log);
    EXPECT_TRUE(d.Has(List("P", "point3")));
    EXPECT_EQ(d.GetOneFloat(F("f", 7)), 7);
    EXPECT_TRUE(d.GetPoint3fArray(List("P", "point3")).empty());
    EXPECT_FALSE(d.GetOneSpectrum(L("c", SpectrumType::Albedo)));
    d.ReportUnused();
    EXPECT_EQ(parsed->Messages().size(), 3u);
}

}  // namespace
}  // namespace pbrt
