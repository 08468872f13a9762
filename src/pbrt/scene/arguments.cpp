// The arguments of directives: names, numbers, matrices.

#include <fmt/format.h>

#include "pbrt/scene/number.h"
#include "pbrt/scene/parser.h"

namespace pbrt {
namespace {

bool IsDirective(const Token &t) {
    return t.kind == TokenKind::Word && FindDirective(t.text);
}

}  // namespace

std::optional<std::string> Parser::Name(std::string_view what) {
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

std::optional<Entity> Parser::NamedEntity(std::string_view what) {
    std::optional<std::string> type = Name(what);
    if (!type) return {};
    return EntityOfType(std::move(*type));
}

Entity Parser::EntityOfType(std::string type) {
    const FileLoc loc = at;
    return {std::move(type), loc, parameters.Read(*lexer, builder.ColorSpace()),
            builder.ColorSpace()};
}

template <typename Describe>
bool Parser::NextNumber(float *value, Describe describe) {
    const Token &t = lexer->Peek();
    const bool word = t.kind == TokenKind::Word;
    const std::optional<float> number = word ? ParseFloat(t.text) : std::nullopt;
    if (!number && (!word || IsDirective(t))) return Expected(describe()), false;
    if (!number) Error(lexer->Loc(), fmt::format("{}: {}", describe(), WhyNotFloat(t.text)));
    *value = number.value_or(0);
    lexer->Advance();
    return number.has_value();
}

std::optional<std::vector<float>> Parser::Numbers(std::span<const std::string_view> labels) {
    std::vector<float> numbers(labels.size());
    for (size_t i = 0; i < labels.size(); ++i) {
        const auto which = [&] {
            return fmt::format("number {} of {} ({})", i + 1, labels.size(), labels[i]);
        };
        if (!NextNumber(&numbers[i], which)) return Resynchronise(), std::nullopt;
    }
    return numbers;
}

/// 16 numbers in brackets, column after column.
std::optional<Matrix4> Parser::BracketedMatrix() {
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

void Parser::Expected(std::string_view what) {
    const Token &t = lexer->Peek();
    if (t.kind == TokenKind::Broken || lexer->ReportMissingQuote()) return;  // by the lexer
    Error(lexer->Loc(), fmt::format("expected {}, found {}", what, Describe(t)));
}

void Parser::Error(const FileLoc &loc, std::string_view message) {
    log->Error(loc, fmt::format("{}: {}", directive->name, message));
}

}  // namespace pbrt
