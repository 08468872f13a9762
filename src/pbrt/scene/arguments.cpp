#include "pbrt/scene/arguments.h"

#include <fmt/format.h>

#include <cctype>

#include "pbrt/scene/number.h"

namespace pbrt {

bool MayBeDirective(std::string_view word) {
    return std::isalpha(static_cast<unsigned char>(word[0])) && word != "true" && word != "false";
}

std::optional<std::string> Arguments::Name(std::string_view what) {
    const Token &t = lexer->Peek();
    if (lexer->Peek().kind == TokenKind::Word && lexer->ReportMissingQuote())
        return Resynchronise(), std::nullopt;
    if (t.kind == TokenKind::Word && !IsDirective(t)) {
        Error(lexer->Loc(), fmt::format("{} must be quoted: \"{}\"", what, t.text));
    } else if (t.kind != TokenKind::String) {
        Expected(fmt::format("{} in quotes", what));
        return Resynchronise(), std::nullopt;
    }
    std::string name(t.text);
    lexer->Advance();
    return name;
}

std::optional<Entity> Arguments::NamedEntity(std::string_view what,
                                             const RGBColorSpace *colorSpace) {
    std::optional<std::string> type = Name(what);
    if (!type) return {};
    return EntityOfType(std::move(*type), colorSpace);
}

Entity Arguments::EntityOfType(std::string type, const RGBColorSpace *colorSpace) {
    return {std::move(type), at, Parameters(colorSpace), colorSpace};
}

template <typename Describe>
bool Arguments::NextNumber(float *value, Describe describe) {
    const Token &t = lexer->Peek();
    const bool word = t.kind == TokenKind::Word;
    const std::optional<float> number = word ? ParseFloat(t.text) : std::nullopt;
    if (!number && (!word || IsDirective(t))) return Expected(describe()), false;
    if (!number) Error(lexer->Loc(), fmt::format("{}: {}", describe(), WhyNotFloat(t.text)));
    *value = number.value_or(0);
    lexer->Advance();
    return number.has_value();
}

std::optional<std::vector<float>> Arguments::Numbers(std::span<const std::string_view> labels) {
    std::vector<float> numbers(labels.size());
    for (size_t i = 0; i < labels.size(); ++i) {
        const auto which = [&] {
            return fmt::format("number {} of {} ({})", i + 1, labels.size(), labels[i]);
        };
        if (!NextNumber(&numbers[i], which)) return Resynchronise(), std::nullopt;
    }
    return numbers;
}

std::optional<Matrix4> Arguments::BracketedMatrix() {
    if (lexer->Peek().kind != TokenKind::Open) {
        Expected("\"[\" and the 16 numbers of a matrix");
        return Resynchronise(), std::nullopt;
    }
    lexer->Advance();
    depth = 1;
    Matrix4 m;
    for (int i = 0; i < 16; ++i)
        if (!NextNumber(&m[i % 4][i / 4], [&] { return fmt::format("number {} of 16", i + 1); }))
            return Resynchronise(), std::nullopt;
    if (lexer->Peek().kind != TokenKind::Close) {
        Expected("\"]\" after the 16 numbers of a matrix");
        return Resynchronise(), std::nullopt;
    }
    lexer->Advance();
    return m;
}

void Arguments::Expected(std::string_view what) {
    const Token &t = lexer->Peek();
    if (t.kind == TokenKind::Broken || lexer->ReportMissingQuote()) return;  // by the lexer
    Error(lexer->Loc(), fmt::format("expected {}, found {}", what, Describe(t)));
}

void Arguments::Error(const FileLoc &loc, std::string_view message) {
    log->Error(loc, fmt::format("{}: {}", directive, message));
}

void Arguments::Resynchronise() {
    for (; lexer->Peek().kind != TokenKind::End; lexer->Advance()) {
        const Token &t = lexer->Peek();
        if (t.kind == TokenKind::Open) ++depth;
        if (t.kind == TokenKind::Close && depth > 0) --depth;
        if (t.kind != TokenKind::Word) continue;
        const bool misspelt = depth == 0 && lexer->AtLineStart() && MayBeDirective(t.text);
        if (misspelt || isDirective(t.text)) return;
    }
}

}  // namespace pbrt
