#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace pbrt {

/// The end of the comment or of the quoted word that begins at text[at], quotes included; of a word
/// that is not closed, the end of the line.
inline size_t EndOfComment(std::string_view text, size_t at) {
    return std::min(text.find_first_of("\n\r", at), text.size());
}
inline size_t EndOfQuoted(std::string_view text, size_t at) {
    for (++at; at < text.size(); ++at) {
        if (text[at] == '"') return at + 1;
        if (text[at] == '\n') return at;
        if (text[at] == '\\') ++at;
    }
    return text.size();
}

/// Calls f(word) for each quoted word of scene text, without quotes and with \" and \\ resolved.
/// Faster than the lexer by what it does not look at: numbers, places, mistakes.
template <typename F>
void ForEachQuotedWord(std::string_view text, const F &f) {
    size_t quote = 0, comment = 0;  // the next of each, from `at` on
    for (size_t at = 0;;) {
        if (quote != text.npos && quote <= at) quote = text.find('"', at);
        if (comment != text.npos && comment <= at) comment = text.find('#', at);
        if (quote == text.npos) return;
        if (comment < quote) {
            at = EndOfComment(text, comment);
            continue;
        }
        at = quote;
        const size_t end = EndOfQuoted(text, at);
        std::string word;
        for (size_t i = at + 1; i < end && text[i] != '"' && text[i] != '\n'; ++i) {
            if (text[i] == '\\' && i + 1 < end) ++i;
            word += text[i];
        }
        f(word);
        at = end;
    }
}

}  // namespace pbrt
