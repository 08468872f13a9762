#include "pbrt/scene/lexer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pbrt {
namespace {

struct Lexed {
    std::vector<std::string> tokens;  ///< strings in quotes, broken ones with a mark
    std::vector<std::pair<int, int>> places;
    std::vector<std::string> messages;
};

Lexed Lex(std::string_view text) {
    Diagnostics log;
    Lexed result;
    for (Lexer lexer(text, "f", &log); lexer.Peek().kind != TokenKind::End; lexer.Advance()) {
        const Token &t = lexer.Peek();
        std::string shown(t.text);
        if (t.kind == TokenKind::String) shown = '"' + shown + '"';
        if (t.kind == TokenKind::Broken) shown = '!' + shown;
        result.tokens.push_back(shown);
        result.places.emplace_back(t.line, t.column);
    }
    for (const Message &m : log.Messages())
        result.messages.push_back(m.text);
    return result;
}

using Strings = std::vector<std::string>;
using Places = std::vector<std::pair<int, int>>;

TEST(Lexer, SplitsAtBlanksBracketsAndQuotes) {
    EXPECT_EQ(Lex("Shape\"sphere\"\"float radius\"[2]\t-1e3\r\nX").tokens,
              (Strings{"Shape", "\"sphere\"", "\"float radius\"", "[", "2", "]", "-1e3", "X"}));
    EXPECT_EQ(Lex("").tokens, Strings{});
    EXPECT_EQ(Lex(" \n\t\r\n ").tokens, Strings{});
}

TEST(Lexer, CommentsRunToTheEndOfTheLine) {
    EXPECT_EQ(Lex("A # B \"C\n#\nD#E # F").tokens, (Strings{"A", "D#E"}));
    EXPECT_EQ(Lex("\"a # b\" #").tokens, (Strings{"\"a # b\""}));
}

TEST(Lexer, PlacesCountFromOne) {
    EXPECT_EQ(Lex("A bc\n  [\"d\" 1]\n# x\n\tE").places,
              (Places{{1, 1}, {1, 3}, {2, 3}, {2, 4}, {2, 8}, {2, 9}, {4, 2}}));
}

TEST(Lexer, ColumnsCountCharactersNotBytes) {
    EXPECT_EQ(Lex("\"\xC3\xA4\xE2\x82\xAC\" x\ny").places, (Places{{1, 1}, {1, 6}, {2, 1}}));
    EXPECT_EQ(Lex("\xC3\xA4 x").places, (Places{{1, 1}, {1, 3}}));
    EXPECT_EQ(Lex("\"\\n\xC3\xA4\" x").places, (Places{{1, 1}, {1, 7}}));
}

TEST(Lexer, SkipsAUtf8ByteOrderMark) {
    const Lexed lexed = Lex("\xEF\xBB\xBFWorldBegin");
    EXPECT_EQ(lexed.tokens, Strings{"WorldBegin"});
    EXPECT_EQ(lexed.places, (Places{{1, 1}}));
}

TEST(Lexer, ResolvesEscapes) {
    EXPECT_EQ(Lex(R"("a\\b\"c\'d" "\n\t\r\b\f")").tokens,
              (Strings{"\"a\\b\"c'd\"", "\"\n\t\r\b\f\""}));
    EXPECT_EQ(Lex(R"("\\" x)").tokens, (Strings{"\"\\\"", "x"}));
}

TEST(Lexer, UnknownEscapeIsAnErrorAndReadingGoesOn) {
    const Lexed lexed = Lex(R"(A "x\qy" B)");
    EXPECT_EQ(lexed.tokens, (Strings{"A", "\"xqy\"", "B"}));
    EXPECT_EQ(lexed.messages, Strings{R"(f:1:5: unknown escape "\q" in a string; known: )"
                                      R"(\b \f \n \r \t \\ \' \")"});
}

TEST(Lexer, UnclosedStringIsAnErrorAtItsStart) {
    const Lexed line = Lex("A \"bc\r\nD");
    EXPECT_EQ(line.tokens, (Strings{"A", "!bc", "D"}));
    EXPECT_EQ(line.messages,
              Strings{"f:1:3: the string \"bc\" is not closed before the end of its line"});
    const Lexed file = Lex("A \"bc");
    EXPECT_EQ(file.messages,
              Strings{"f:1:3: the string \"bc\" is not closed before the end of its file"});
    const Lexed escape = Lex("\"bc\\");
    EXPECT_EQ(escape.messages,
              Strings{"f:1:1: the string \"bc\\\" is not closed before the end of its file"});
    const Lexed escapedQuote = Lex("\"bc\\\"\nX");
    EXPECT_EQ(escapedQuote.tokens, (Strings{"!bc\"", "X"}));
}

TEST(Lexer, ReadsShortNumbersUpToAnythingElse) {
    Diagnostics log;
    Lexer lexer("1 -2.5\n# 7\n\t3]4 1e2 5 6\xC3\xA4 7 123456789 x", "f", &log);
    std::vector<float> numbers;
    const auto read = [&] {
        numbers.clear();
        lexer.ReadShortNumbers(&numbers);
        return numbers;
    };
    EXPECT_EQ(read(), (std::vector<float>{1, -2.5, 3}));
    EXPECT_EQ(lexer.Peek().kind, TokenKind::Close);
    EXPECT_EQ(lexer.Loc(), (FileLoc{"f", 3, 3}));
    EXPECT_EQ(read(), std::vector<float>{});
    lexer.Advance();
    EXPECT_EQ(read(), std::vector<float>{4});
    EXPECT_EQ(lexer.Peek().text, "1e2");
    lexer.Advance();
    EXPECT_EQ(read(), std::vector<float>{5});
    EXPECT_EQ(lexer.Peek().text, "6\xC3\xA4");
    EXPECT_EQ(read(), std::vector<float>{});
    lexer.Advance();
    EXPECT_EQ(lexer.Loc(), (FileLoc{"f", 3, 15}));
    EXPECT_EQ(read(), std::vector<float>{7});
    EXPECT_EQ(lexer.Peek().text, "123456789");
}

TEST(Lexer, ShowsLongTokensShortened) {
    EXPECT_EQ(Describe({TokenKind::Word, 1, 1, "abc"}), "\"abc\"");
    EXPECT_EQ(Describe({TokenKind::String, 1, 1, "abc"}), "the string \"abc\"");
    EXPECT_EQ(Describe({TokenKind::End, 1, 1, ""}), "the end of the file");
    const std::string longWord(100, 'x'), shown(60, 'x');
    EXPECT_EQ(Describe({TokenKind::Word, 1, 1, longWord}), fmt::format("\"{}...\"", shown));
}

}  // namespace
}  // namespace pbrt
