#include "pbrt/scene/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pbrt/scene/number.h"

namespace pbrt {
namespace {

enum CharClass : uint8_t { Plain, Blank, Delimiter, Continuation };

/// Classes of the bytes: those that end a word, and those that do not count as a column.
constexpr std::array<CharClass, 256> kClasses = [] {
    std::array<CharClass, 256> c{};
    for (char blank : {' ', '\t', '\n', '\r'})
        c[static_cast<unsigned char>(blank)] = Blank;
    for (char delimiter : {'"', '[', ']'})
        c[static_cast<unsigned char>(delimiter)] = Delimiter;
    for (int i = 0x80; i < 0xC0; ++i)
        c[i] = Continuation;
    return c;
}();

CharClass Class(char c) {
    return kClasses[static_cast<unsigned char>(c)];
}

/// The character that `\c` stands for; 0 where there is no such escape.
char Unescaped(char c) {
    switch (c) {
        case 'b':
            return '\b';
        case 'f':
            return '\f';
        case 'n':
            return '\n';
        case 'r':
            return '\r';
        case 't':
            return '\t';
        case '\\':
        case '\'':
        case '"':
            return c;
        default:
            return 0;
    }
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string_view file, Diagnostics *log)
    : begin(text.data()),
      next(begin),
      end(begin + text.size()),
      tokenStart(begin),
      lastEnd(begin),
      lineStart(begin),
      file(file),
      log(log) {
    if (text.starts_with("\xEF\xBB\xBF")) lineStart = next += 3;
    token.line = 0;
    Advance();
}

void Lexer::Advance() {
    lastLine = token.line;
    lastEnd = next;
    SkipBlanks();
    tokenStart = next;
    token.line = line;
    token.column = Column(next);
    if (next == end) {
        token.kind = TokenKind::End;
        token.text = {};
    } else if (*next == '"') {
        ReadString();
    } else if (*next == '[' || *next == ']') {
        token.kind = *next == '[' ? TokenKind::Open : TokenKind::Close;
        token.text = {next++, 1};
    } else {
        ReadWord();
    }
}

void Lexer::ReadShortNumbers(std::vector<float> *numbers) {
    float value = 0;
    if (token.kind != TokenKind::Word || ParseShortDecimal(token.text.data(), next, &value) != next)
        return;
    numbers->push_back(value);
    SkipBlanks();
    while (const char *const stop = ParseShortDecimal(next, end, &value)) {
        if (stop != end && Class(*stop) != Blank && *stop != ']') break;
        numbers->push_back(value);
        next = stop;
        SkipBlanks();
    }
    Advance();
}

void Lexer::SkipBlanks() {
    for (; next != end; ++next) {
        if (*next == '\n') {
            ++line;
            lineStart = next + 1;
        } else if (*next == '#') {
            while (next + 1 != end && next[1] != '\n')
                ++next;
        } else if (Class(*next) != Blank) {
            break;
        }
    }
}

void Lexer::ReadWord() {
    const char *start = next;
    for (; next != end; ++next) {
        const CharClass c = Class(*next);
        if (c == Continuation)
            ++lineStart;
        else if (c != Plain)
            break;
    }
    token.kind = TokenKind::Word;
    token.text = {start, size_t(next - start)};
}

void Lexer::ReadString() {
    const char *start = ++next;
    for (; next != end && *next != '"' && *next != '\n'; ++next) {
        if (*next == '\\') return ReadEscapedString(start);
        if (Class(*next) == Continuation) ++lineStart;
    }
    EndString({start, size_t(next - start)}, next != end && *next == '"');
}

void Lexer::ReadEscapedString(const char *start) {
    std::string &text = unescaped.emplace_back(start, next);
    for (; next != end && *next != '"' && *next != '\n'; ++next) {
        char c = *next;
        if (c == '\\' && next + 1 != end && next[1] != '\n') {
            c = Unescaped(*++next);
            if (c == 0) {
                log->Error({file, line, Column(next - 1)},
                           fmt::format("unknown escape \"\\{}\" in a string; known: "
                                       "\\b \\f \\n \\r \\t \\\\ \\' \\\"",
                                       *next));
                c = *next;
            }
        }
        if (Class(*next) == Continuation) ++lineStart;
        text += c;
    }
    EndString(text, next != end && *next == '"');
}

void Lexer::EndString(std::string_view text, bool closed) {
    token.text = text;
    token.kind = closed ? TokenKind::String : TokenKind::Broken;
    if (closed) {
        ++next;
        return;
    }
    if (token.text.ends_with('\r')) token.text.remove_suffix(1);
    log->Error(Loc(token), fmt::format("the string \"{}\" is not closed before the end of its {}",
                                       token.text, next == end ? "file" : "line"));
}

bool Lexer::ReportMissingQuote() {
    if (token.kind == TokenKind::End || token.kind == TokenKind::Broken) return false;
    const char *c = tokenStart;
    while (c != begin && c[-1] != '\n')
        --c;
    bool inString = false;
    for (; c != end && *c != '\n' && (inString || *c != '#'); ++c) {
        if (*c == '"') inString = !inString;
        if (*c == '\\' && c + 1 != end && c[1] != '\n') ++c;
    }
    if (!inString) return false;
    log->Error(Loc(), "a quotation mark is missing on this line, here or before");
    next = std::find(c, end, '\n');
    Advance();
    return true;
}

std::string Describe(const Token &token) {
    constexpr size_t kLongest = 60;
    std::string text(token.text.substr(0, kLongest));
    if (token.text.size() > kLongest) text += "...";
    switch (token.kind) {
        case TokenKind::End:
            return "the end of the file";
        case TokenKind::String:
        case TokenKind::Broken:
            return fmt::format("the string \"{}\"", text);
        default:
            return fmt::format("\"{}\"", text);
    }
}

}  // namespace pbrt
