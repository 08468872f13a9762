#include "pbrt/scene/parameter_reader.h"

#include <fmt/format.h>

#include <iterator>

#include "pbrt/scene/number.h"
#include "pbrt/util/upstream.h"

namespace pbrt {
namespace {

/// A string that can only be the next parameter's declaration.
bool IsDeclaration(const Token &t) {
    if (t.kind != TokenKind::String) return false;
    const Declaration d = SplitDeclaration(t.text);
    return !d.name.empty() && FindParamType(d.type);
}

bool IsTrueOrFalse(std::string_view text) {
    return text == "true" || text == "false";
}

/// A bare value where no parameter expects one.
bool IsLooseValue(const Token &t) {
    return t.kind == TokenKind::Word && (ParseFloat(t.text) || IsTrueOrFalse(t.text));
}

}  // namespace

bool ParameterReader::EndsParameter(const Token &t) const {
    return t.kind == TokenKind::End || IsDirective(t) || IsDeclaration(t);
}

ParsedParameters ParameterReader::Read(Lexer &lexer, const RGBColorSpace *colorSpace) {
    parameters.clear();
    while (lexer.Peek().kind == TokenKind::String || lexer.Peek().kind == TokenKind::Broken) {
        if (lexer.Peek().kind == TokenKind::Broken) {
            lexer.Advance();
            SkipValues(lexer);
        } else {
            ReadOne(lexer, colorSpace);
        }
    }
    return ParsedParameters(std::make_move_iterator(parameters.begin()),
                            std::make_move_iterator(parameters.end()));
}

void ParameterReader::ReadOne(Lexer &lexer, const RGBColorSpace *colorSpace) {
    const FileLoc loc = lexer.Loc();
    declaration = lexer.Peek().text;
    const Declaration d = SplitDeclaration(declaration);
    if (d.name.empty() && lexer.ReportMissingQuote()) return;
    lexer.Advance();
    if (d.name.empty()) {
        log->Error(loc, fmt::format("expected a parameter declaration \"type name\", found \"{}\"",
                                    declaration));
        return SkipValues(lexer);
    }
    const ParamType *const type = FindParamType(d.type);
    const ParamType *const meant = type ? type : ReportUnknownType(d, loc);
    if (!meant) return SkipValues(lexer);
    ParsedParameter &p = parameters.emplace_back();
    p.type = meant->name;
    p.name = d.name;
    p.loc = loc;
    p.valueLoc = lexer.Loc();
    p.colorSpace = colorSpace;
    if (!type) return SkipValues(lexer);
    if (ReadValues(lexer, *type, &p.valueLoc)) KeepValues(&p);
}

const ParamType *ParameterReader::ReportUnknownType(const Declaration &d, const FileLoc &loc) {
    const std::string_view newName = NewNameOfType(d.type);
    const OldName *const old = FindOldName("parameter type", d.type);
    if (old && !log->NoteOldName(*old, loc)) return FindParamType(newName);
    const std::string hint = newName.empty() ? DidYouMean(d.type, ParamTypeNames())
                                             : fmt::format("; pbrt-v4 calls it \"{}\"", newName);
    log->Error(loc,
               fmt::format("unknown parameter type \"{}\" in \"{}\"{}", d.type, declaration, hint));
    return FindParamType(newName.empty() ? NearestName(d.type, ParamTypeNames()) : newName);
}

bool ParameterReader::ReadValues(Lexer &lexer, const ParamType &type, FileLoc *first) {
    floats.clear(), ints.clear(), strings.clear(), bools.clear();
    inList = lexer.Peek().kind == TokenKind::Open;
    if (inList) {
        lexer.Advance();
        *first = lexer.Loc();
        return ReadList(lexer, type);
    }
    const bool right = ReadValue(lexer, type) && IsLast(lexer);
    if (!right) SkipValues(lexer);
    return right;
}

void ParameterReader::KeepValues(ParsedParameter *p) {
    if (!floats.empty()) p->floats = floats;
    if (!ints.empty()) p->ints = ints;
    if (!bools.empty()) p->bools = bools;
    if (!strings.empty())
        p->strings.assign(std::make_move_iterator(strings.begin()),
                          std::make_move_iterator(strings.end()));
}

bool ParameterReader::ReadList(Lexer &lexer, const ParamType &type) {
    if (lexer.Peek().kind == TokenKind::Close) {
        Fail(lexer.Loc(), "the list is empty");
        lexer.Advance();
        return false;
    }
    const bool numbers = type.kind == ValueKind::Float;
    if (numbers) lexer.ReadShortNumbers(&floats);
    while (lexer.Peek().kind != TokenKind::Close) {
        if (!ReadValue(lexer, type)) {
            SkipList(lexer);
            return false;
        }
        if (numbers) lexer.ReadShortNumbers(&floats);
    }
    lexer.Advance();
    return true;
}

bool ParameterReader::ReadValue(Lexer &lexer, const ParamType &type) {
    constexpr NumberSyntax<float> kFloat{"a number", ParseFloat, WhyNotFloat};
    constexpr NumberSyntax<int> kInt{"an integer", ParseInt, WhyNotInt};
    switch (type.kind) {
        case ValueKind::Float:
            return ReadNumber(lexer, kFloat, &floats);
        case ValueKind::Int:
            return ReadNumber(lexer, kInt, &ints);
        case ValueKind::Bool:
            return ReadBool(lexer);
        case ValueKind::String:
            return ReadString(lexer);
        case ValueKind::FloatOrString:
            break;
    }
    const bool string = lexer.Peek().kind == TokenKind::String;
    if ((string && floats.empty()) || !strings.empty()) return ReadString(lexer);
    return ReadNumber(lexer, kFloat, &floats);
}

bool ParameterReader::ReadString(Lexer &lexer) {
    const Token &t = lexer.Peek();
    if (t.kind != TokenKind::String) return Expected(lexer, "a quoted string");
    strings.emplace_back(t.text);
    lexer.Advance();
    return true;
}

template <typename Number>
bool ParameterReader::ReadNumber(Lexer &lexer, const NumberSyntax<Number> &syntax,
                                 std::vector<Number> *values) {
    const Token &t = lexer.Peek();
    const bool word = t.kind == TokenKind::Word;
    const std::optional<Number> value = word ? syntax.parse(t.text) : std::nullopt;
    if (!value) {
        if (!word || IsDirective(t)) return Expected(lexer, syntax.what);
        return Fail(lexer.Loc(), syntax.whyNot(t.text));
    }
    values->push_back(*value);
    lexer.Advance();
    return true;
}

bool ParameterReader::ReadBool(Lexer &lexer) {
    const Token &t = lexer.Peek();
    if (!IsTrueOrFalse(t.text)) return Expected(lexer, "true or false");
    if (t.kind == TokenKind::String)
        return Fail(lexer.Loc(), fmt::format("write {} without quotes", t.text));
    bools.push_back(t.text == "true");
    lexer.Advance();
    return true;
}

/// `"point3 P" 0 0 1`: the first number is the value, the others lack their brackets.
bool ParameterReader::IsLast(Lexer &lexer) {
    if (!IsLooseValue(lexer.Peek())) return true;
    return Fail(lexer.Loc(), fmt::format("found a second value {}; write several values in [ ]",
                                         Describe(lexer.Peek())));
}

void ParameterReader::SkipValues(Lexer &lexer) {
    if (lexer.Peek().kind == TokenKind::Open) {
        lexer.Advance();
        SkipList(lexer);
        return;
    }
    if (!EndsParameter(lexer.Peek())) lexer.Advance();
    while (IsLooseValue(lexer.Peek()))
        lexer.Advance();
}

void ParameterReader::SkipList(Lexer &lexer) {
    for (int depth = 1; depth > 0 && !EndsParameter(lexer.Peek()); lexer.Advance()) {
        if (lexer.Peek().kind == TokenKind::Open) ++depth;
        if (lexer.Peek().kind == TokenKind::Close) --depth;
    }
}

bool ParameterReader::Fail(const FileLoc &loc, std::string_view message) {
    log->Error(loc, fmt::format("\"{}\": {}", declaration, message));
    return false;
}

bool ParameterReader::Expected(Lexer &lexer, std::string_view what) {
    if (lexer.ReportMissingQuote()) return false;
    const Token &t = lexer.Peek();
    if (t.kind == TokenKind::Broken) return false;  // reported by the lexer
    return Fail(lexer.Loc(), fmt::format("expected {}{}, found {}", what, inList ? " or \"]\"" : "",
                                         Describe(t)));
}

}  // namespace pbrt
