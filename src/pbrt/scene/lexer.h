#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/util/diagnostics.h"

namespace pbrt {

enum class TokenKind : uint8_t {
    End,
    Word,    ///< bare: directives, numbers, true, false
    String,  ///< quoted; `text` without the quotes, escapes resolved
    Open,    ///< [
    Close,   ///< ]
    Broken,  ///< an unterminated string, already reported
};

struct Token {
    TokenKind kind = TokenKind::End;
    int line = 1, column = 1;  ///< of the first character, from 1; columns count code points
    std::string_view text;     ///< valid as long as the lexer and its text
};

/// Splits the text of one scene file into tokens (PBRT_FORMAT 1.1), one ahead of the reader.
/// Written by hand: the grammar is four rules long and speed matters.
class Lexer {
  public:
    /// `text` and `file` must outlive the lexer. A UTF-8 byte order mark is skipped.
    Lexer(std::string_view text, std::string_view file, Diagnostics *log);

    /// The token not yet consumed.
    const Token &Peek() const { return token; }
    void Advance();
    /// True where the token not yet consumed is the first on its line.
    bool AtLineStart() const { return token.line > lastLine; }
    /// The token not yet consumed as it is written, quotes and escapes included.
    std::string_view Written() const { return {tokenStart, size_t(next - tokenStart)}; }
    /// Blanks and comments between it and the token before; not after ReadShortNumbers().
    std::string_view Before() const { return {lastEnd, size_t(tokenStart - lastEnd)}; }
    /// Consumes the plain short numbers (ParseShortDecimal) that follow, appending them to
    /// `numbers`; stops at any other token. A short cut past the tokens for long lists.
    void ReadShortNumbers(std::vector<float> *numbers);
    FileLoc Loc(const Token &t) const { return {file, t.line, t.column}; }
    /// Place of the token not yet consumed.
    FileLoc Loc() const { return Loc(token); }
    /// Reports that a quote is missing on the line of the token not yet consumed, instead of errors
    /// that only follow from it, and passes over the line; false where none is missing. Call it
    /// before any other error about the token.
    bool ReportMissingQuote();

  private:
    void SkipBlanks();
    void ReadWord();
    void ReadString();
    /// The rest of a string from its first backslash on, into storage of its own.
    void ReadEscapedString(const char *start);
    void EndString(std::string_view text, bool closed);
    int Column(const char *p) const { return int(p - lineStart) + 1; }

    const char *const begin;
    const char *next, *end;
    const char *tokenStart;
    const char *lastEnd;    ///< of the token consumed last
    const char *lineStart;  ///< moved on by one for every UTF-8 continuation byte of the line
    int line = 1;
    int lastLine = 0;  ///< of the token consumed last
    Token token;
    std::string_view file;
    Diagnostics *log;
    std::deque<std::string> unescaped;
};

/// The token as messages show it, long texts cut: `"x"`, `the string "x"`, `the end of the file`.
std::string Describe(const Token &token);

}  // namespace pbrt
