#include "pbrt/util/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

#include "pbrt/util/upstream.h"

namespace pbrt {

std::string Shortened(std::string_view text, size_t most) {
    constexpr std::string_view kGap = " ... ";
    const size_t half = (most - std::min(most, kGap.size())) / 2;
    std::string shown = text.size() <= most ? std::string(text)
                                            : fmt::format("{}{}{}", text.substr(0, half), kGap,
                                                          text.substr(text.size() - half));
    for (char &c : shown)
        if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') c = '?';
    return shown;
}

void Diagnostics::Error(const FileLoc &loc, std::string_view message) {
    Add(Severity::Error, loc, message);
}

void Diagnostics::Warning(const FileLoc &loc, std::string_view message) {
    Add(Severity::Warning, loc, message);
}

void Diagnostics::WarningOnce(const FileLoc &loc, std::string_view message) {
    if (warnedOnce.emplace(message).second) Warning(loc, message);
}

void Diagnostics::Add(Severity severity, const FileLoc &loc, std::string_view message) {
    constexpr size_t kLongest = 2000;
    if (severity == Severity::Error) ++errors;
    std::string text = Shortened(
        loc.line > 0       ? fmt::format("{}:{}:{}: {}", loc.file, loc.line, loc.column, message)
        : loc.file.empty() ? std::string(message)
                           : fmt::format("{}: {}", loc.file, message),
        kLongest);
    if (!messages.empty() && messages.back().text == text) return;
    messages.push_back({severity, std::move(text)});
}

namespace {

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal
/// string alignment), letters' case ignored.
int Edits(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    };
    std::vector<int> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (size_t i = 1; i <= a.size(); ++i) {
        std::swap(beforeLast, last);
        std::swap(last, row);
        row[0] = int(i);
        for (size_t j = 1; j <= b.size(); ++j) {
            const int replaced = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row.back();
}

}  // namespace

std::string_view NearestName(std::string_view name, std::span<const std::string_view> candidates) {
    std::string_view best;
    constexpr size_t kLongest = 200;  // the time goes by the product of the lengths
    if (name.size() > kLongest) return best;
    int fewest = 1 << 30;
    for (std::string_view c : candidates) {
        // An abbreviation is as near as a single edit.
        const int edits = name.size() >= 3 && c.starts_with(name) ? 1 : Edits(name, c);
        if (edits < fewest && 3 * edits <= int(std::max(name.size(), c.size()))) {
            fewest = edits;
            best = c;
        }
    }
    return best;
}

std::string DidYouMean(std::string_view name, std::span<const std::string_view> candidates) {
    const std::string_view nearest = NearestName(name, candidates);
    return nearest.empty() ? std::string() : fmt::format("; did you mean \"{}\"?", nearest);
}

std::string UnknownName(std::string_view kind, std::string_view name,
                        std::span<const std::string_view> known) {
    const std::string upstream = PbrtHasIt(kind, name);
    const std::string hint = upstream.empty() ? DidYouMean(name, known) : upstream + '.';
    return fmt::format("unknown {} \"{}\"{} Known: {}", kind, Shortened(name),
                       hint.empty() ? "." : hint, QuotedList(known));
}

std::string QuotedList(std::span<const std::string_view> names) {
    std::string list;
    for (size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
        list += fmt::format("\"{}\"", names[i]);
    }
    return list;
}

}  // namespace pbrt
