#include "pbrt/scene/option_directive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "pbrt/scene/number.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 3> kCoordSys{"camera", "cameraworld", "world"};
constexpr BoolParam kDisablePixelJitter{"disablepixeljitter", false,
                                        "samples in the pixels' centres only"};
constexpr BoolParam kDisableWavelengthJitter{"disablewavelengthjitter", false,
                                             "the same wavelengths for every path"};
constexpr BoolParam kDisableTextureFiltering{"disabletexturefiltering", false,
                                             "point-sampled textures"};
constexpr BoolParam kForceDiffuse{
    "forcediffuse", false, "every surface is diffuse and reflects as much as its material does"};
constexpr BoolParam kPixelStats{"pixelstats", false,
                                "write NAME-stats.exr beside the picture: samples, seconds, rays"};
constexpr IntParam kSeed{"seed", 0, kLeastInt, kMostInt, "of the samplers' random numbers"};
constexpr ChoiceParam kRenderCoordSys{"rendercoordsys", kCoordSys[1], kCoordSys,
                                      "the space to render in"};
constexpr StringParam kMseReferenceImage{"msereferenceimage", "",
                                         "picture without noise, to tell the error of this one"};
constexpr StringParam kMseReferenceOut{
    "msereferenceout", "", "file for lines \"spp, mean squared error\" at 1, 2, 4, ... samples"};
constexpr std::array<ParamRow, 9> kRows{kDisablePixelJitter,
                                        kDisableWavelengthJitter,
                                        kDisableTextureFiltering,
                                        kForceDiffuse,
                                        kPixelStats,
                                        kSeed,
                                        kRenderCoordSys,
                                        kMseReferenceImage,
                                        kMseReferenceOut};
/// Known to pbrt-v4, without a meaning here.
constexpr std::array<std::string_view, 2> kIgnored{"displacementedgescale", "wavefront"};
constexpr auto kNames = [] {
    std::array<std::string_view, kRows.size() + kIgnored.size()> names;
    for (size_t i = 0; i < kRows.size(); ++i)
        names[i] = std::visit([](const auto &row) { return row.name; }, kRows[i]);
    std::copy(kIgnored.begin(), kIgnored.end(), names.begin() + kRows.size());
    return names;
}();

/// Letters' case, "-" and "_" do not count.
std::string Normalised(std::string_view name) {
    std::string plain;
    for (char c : name)
        if (c != '-' && c != '_') plain += char(std::tolower(static_cast<unsigned char>(c)));
    return plain;
}

void SkipValue(DirectiveContext &c) {
    const Token &t = c.arguments.Peek();
    const bool word = t.kind == TokenKind::Word && !c.arguments.IsDirective(t);
    if (word || t.kind == TokenKind::String) return c.arguments.Advance();
    c.arguments.Resynchronise();
}

void ReadFlag(DirectiveContext &c, bool *flag) {
    const Token &t = c.arguments.Peek();
    if (t.kind == TokenKind::Word && (t.text == "true" || t.text == "false"))
        *flag = t.text == "true";
    else
        c.arguments.Expected("true or false without quotes");
    SkipValue(c);
}

void ReadInt(DirectiveContext &c, int *value) {
    const Token &t = c.arguments.Peek();
    const std::optional<int> number = t.kind == TokenKind::Word ? ParseInt(t.text) : std::nullopt;
    if (number)
        *value = *number;
    else
        c.arguments.Expected("an integer");
    SkipValue(c);
}

void ReadString(DirectiveContext &c, std::string *value) {
    const Token &t = c.arguments.Peek();
    if (t.kind == TokenKind::String)
        *value = t.text;
    else
        c.arguments.Expected("a quoted string");
    SkipValue(c);
}

void ReadCoordSys(DirectiveContext &c) {
    const FileLoc loc = c.arguments.Loc();
    std::string value = c.scene->options.renderCoordSys;
    ReadString(c, &value);
    if (std::find(kCoordSys.begin(), kCoordSys.end(), value) == kCoordSys.end())
        return c.arguments.Error(
            loc, fmt::format("\"{}\" is not one of {}{}", value, QuotedList(kCoordSys),
                             DidYouMean(value, kCoordSys)));
    c.scene->options.renderCoordSys = value;
}

}  // namespace

std::span<const std::string_view> OptionNames() {
    return kNames;
}

std::span<const ParamRow> OptionRows() {
    return kRows;
}

void ReadOption(DirectiveContext &c) {
    const FileLoc loc = c.arguments.Loc();
    const std::optional<std::string> given = c.arguments.Name("the option's name");
    if (!given) return;
    const std::string name = Normalised(*given);
    Options &o = c.scene->options;
    if (name == kDisablePixelJitter.name) return ReadFlag(c, &o.disablePixelJitter);
    if (name == kDisableWavelengthJitter.name) return ReadFlag(c, &o.disableWavelengthJitter);
    if (name == kDisableTextureFiltering.name) return ReadFlag(c, &o.disableTextureFiltering);
    if (name == kForceDiffuse.name) return ReadFlag(c, &o.forceDiffuse);
    if (name == kPixelStats.name) return ReadFlag(c, &o.pixelStats);
    if (name == kSeed.name) return ReadInt(c, &o.seed);
    if (name == kMseReferenceImage.name) return ReadString(c, &o.mseReferenceImage);
    if (name == kMseReferenceOut.name) return ReadString(c, &o.mseReferenceOut);
    if (name == kRenderCoordSys.name) return ReadCoordSys(c);
    if (std::find(kNames.begin(), kNames.end(), name) == kNames.end()) {
        const bool typed = given->find(' ') != given->npos;
        c.arguments.Error(loc, fmt::format("unknown option \"{}\"{}", *given,
                                           typed ? std::string("; write its name without a type")
                                                 : DidYouMean(name, kNames)));
        return SkipValue(c);
    }
    c.log->Warning(loc, fmt::format("Option: \"{}\" has no effect in this renderer", *given));
    SkipValue(c);
}

}  // namespace pbrt
