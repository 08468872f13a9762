// `Option "name" value` (PBRT_FORMAT 1.4).

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "pbrt/scene/number.h"
#include "pbrt/scene/parser.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 11> kNames{
    "disablepixeljitter", "disablewavelengthjitter", "disabletexturefiltering", "forcediffuse",
    "seed", "rendercoordsys", "msereferenceimage", "msereferenceout",
    // Known to pbrt-v4, without a meaning here:
    "displacementedgescale", "pixelstats", "wavefront"};
constexpr std::array<std::string_view, 3> kCoordSys{"camera", "cameraworld", "world"};

/// Letters' case, "-" and "_" do not count.
std::string Normalised(std::string_view name) {
    std::string plain;
    for (char c : name)
        if (c != '-' && c != '_') plain += char(std::tolower(static_cast<unsigned char>(c)));
    return plain;
}

}  // namespace

std::span<const std::string_view> OptionNames() {
    return kNames;
}

void Parser::Option() {
    const FileLoc loc = lexer->Loc();
    const std::optional<std::string> given = Name("the option's name");
    if (!given) return;
    const std::string name = Normalised(*given);
    Options &o = scene->options;
    if (name == "disablepixeljitter") return OptionFlag(&o.disablePixelJitter);
    if (name == "disablewavelengthjitter") return OptionFlag(&o.disableWavelengthJitter);
    if (name == "disabletexturefiltering") return OptionFlag(&o.disableTextureFiltering);
    if (name == "forcediffuse") return OptionFlag(&o.forceDiffuse);
    if (name == "seed") return OptionInt(&o.seed);
    if (name == "msereferenceimage") return OptionString(&o.mseReferenceImage);
    if (name == "msereferenceout") return OptionString(&o.mseReferenceOut);
    if (name == "rendercoordsys") return OptionCoordSys();
    if (std::find(kNames.begin(), kNames.end(), name) == kNames.end()) {
        const bool typed = given->find(' ') != given->npos;
        Error(loc, fmt::format("unknown option \"{}\"{}", *given,
                               typed ? std::string("; write its name without a type")
                                     : DidYouMean(name, kNames)));
        return SkipOptionValue();
    }
    log->Warning(loc, fmt::format("Option: \"{}\" has no effect in this renderer", *given));
    SkipOptionValue();
}

void Parser::SkipOptionValue() {
    const Token &t = lexer->Peek();
    const bool word = t.kind == TokenKind::Word && !FindDirective(t.text);
    if (word || t.kind == TokenKind::String) return lexer->Advance();
    Resynchronise();
}

void Parser::OptionFlag(bool *flag) {
    const Token &t = lexer->Peek();
    if (t.kind == TokenKind::Word && (t.text == "true" || t.text == "false"))
        *flag = t.text == "true";
    else
        Expected("true or false without quotes");
    SkipOptionValue();
}

void Parser::OptionInt(int *value) {
    const Token &t = lexer->Peek();
    const std::optional<int> number = t.kind == TokenKind::Word ? ParseInt(t.text) : std::nullopt;
    if (number)
        *value = *number;
    else
        Expected("an integer");
    SkipOptionValue();
}

void Parser::OptionString(std::string *value) {
    const Token &t = lexer->Peek();
    if (t.kind == TokenKind::String)
        *value = t.text;
    else
        Expected("a quoted string");
    SkipOptionValue();
}

void Parser::OptionCoordSys() {
    const FileLoc loc = lexer->Loc();
    std::string value = scene->options.renderCoordSys;
    OptionString(&value);
    if (std::find(kCoordSys.begin(), kCoordSys.end(), value) == kCoordSys.end())
        return Error(loc, fmt::format("\"{}\" is not one of {}{}", value, QuotedList(kCoordSys),
                                      DidYouMean(value, kCoordSys)));
    scene->options.renderCoordSys = value;
}

}  // namespace pbrt
