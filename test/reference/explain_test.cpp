// The manual as text.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "pbrt/feather/params.h"
#include "pbrt/reference/explain.h"
#include "pbrt/reference/families.h"
#include "support/folders.h"

namespace pbrt::reference {
namespace {

std::string ReadDocument(const std::string &name) {
    std::stringstream text;
    text << std::ifstream(SourceDir() + "/docs/" + name).rdbuf();
    return text.str();
}

TEST(Explain, APlugInIsATable) {
    const Explanation e = Explain("filter \"mitchell\"");
    EXPECT_EQ(e.error, "");
    EXPECT_EQ(e.text,
              "PixelFilter \"mitchell\"\n\n"
              "name     type   unit    default     range\n"
              "xradius  float  pixels  2           [0.001, 1000]\n"
              "         half width\n"
              "yradius  float  pixels  2           [0.001, 1000]\n"
              "         half height\n"
              "B        float          0.33333334  [-10, 10]\n"
              "         blur\n"
              "C        float          0.33333334  [-10, 10]\n"
              "         ringing\n");
    EXPECT_EQ(Explain("filter mitchell").text, e.text);
    EXPECT_EQ(Explain("  filter   mitchell ").text, e.text);
}

TEST(Explain, AFamilyIsAListOfNames) {
    EXPECT_EQ(Explain("sampler").text,
              "zsobol\nindependent\nstratified\nhalton\nsobol\npaddedsobol\npmj02bn\n");
    EXPECT_EQ(Explain("area light").text, "diffuse\n");
}

TEST(Explain, TypesOfBothKindsAndTexturesAreTold) {
    const std::string dielectric = Explain("material dielectric").text;
    EXPECT_NE(dielectric.find("eta             float                     "), std::string::npos)
        << dielectric;
    EXPECT_NE(dielectric.find("eta             rgb, spectrum or blackbody"), std::string::npos)
        << dielectric;
    EXPECT_NE(dielectric.find("roughness       float or texture"), std::string::npos) << dielectric;
}

TEST(Explain, ParametersThatAChoiceBringsAreThere) {
    EXPECT_NE(Explain("float texture imagemap").text.find("\nv1 "), std::string::npos);
}

TEST(Explain, TheFeathersRowsAreTheModels) {
    const std::string text = Explain("material featherbarbule").text;
    for (const feather::FloatParam &p : feather::kParams) {
        EXPECT_NE(text.find(p.name), std::string::npos) << p.name;
        EXPECT_NE(text.find(p.doc), std::string::npos) << p.name;
    }
}

TEST(Explain, UnknownNamesListTheKnownAndTheNearest) {
    EXPECT_EQ(Explain("materiel hair")
                  .error.find(
                      "unknown family \"materiel\"; did you mean \"material\"? Known: \"film\", "),
              0u)
        << Explain("materiel hair").error;
    EXPECT_EQ(
        Explain("material dielectrik")
            .error.find("unknown material \"dielectrik\"; did you mean \"dielectric\"? Known: "),
        0u)
        << Explain("material dielectrik").error;
    EXPECT_NE(Explain("").error, "");
    EXPECT_EQ(Explain("").text, "");
}

TEST(Reference, TheDocumentIsWhatThePlugInsAskFor) {
    EXPECT_TRUE(Explain("all").text == ReadDocument("REFERENCE.md"))
        << "pbrt --explain all > docs/REFERENCE.md brings it up to date";
}

TEST(Reference, NamesArePbrts) {
    // Written there as "u/v" and the like.
    // Written there as conductor.{eta, k, roughness ...} and interface.{...}.
    const std::set<std::string_view> shorthand{"conductor.k",          "conductor.roughness",
                                               "conductor.uroughness", "conductor.vroughness",
                                               "interface.roughness",  "interface.uroughness",
                                               "interface.vroughness"};
    const std::string format = ReadDocument("PBRT_FORMAT.md");
    for (const Family &family : Families())
        for (const std::string_view type : family.types()) {
            if (type == "featherbarbule") continue;
            for (const RequestedParam &param : ParametersOf(family, type)) {
                const std::string name(NameOf(param.row));
                EXPECT_TRUE(shorthand.contains(name) ||
                            std::regex_search(format, std::regex("\\b" + name + "\\b")))
                    << family.name << " " << type << " " << name;
            }
        }
}

}  // namespace
}  // namespace pbrt::reference
