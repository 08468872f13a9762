#include "pbrt/util/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <numeric>
#include <tuple>

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
    if (severity == Severity::Error && FollowsFromMissingFile(loc)) return;
    if (severity == Severity::Error) ++errors;
    std::string text = Shortened(
        loc.line > 0       ? fmt::format("{}:{}:{}: {}", loc.file, loc.line, loc.column, message)
        : loc.file.empty() ? std::string(message)
                           : fmt::format("{}: {}", loc.file, message),
        kLongest);
    if (!messages.empty() && messages.back().text == text) return;
    int file = 0;
    if (!loc.file.empty())
        file = fileNumbers.try_emplace(std::string(loc.file), int(fileNumbers.size()) + 1)
                   .first->second;
    messages.push_back({severity, std::move(text), file, loc.line, loc.column});
}

std::vector<const Message *> Diagnostics::InOrderOfPlace() const {
    std::vector<const Message *> sorted;
    for (const Message &m : messages)
        sorted.push_back(&m);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Message *a, const Message *b) {
        return std::tie(a->file, a->line, a->column) < std::tie(b->file, b->line, b->column);
    });
    return sorted;
}

// --- Missing files ---

namespace {

/// With an end of "/", absolute, for messages; without ".." and ".".
std::string AbsoluteFolder(const std::filesystem::path &folder) {
    std::error_code unknown;
    const std::string path = std::filesystem::absolute(folder.empty() ? "." : folder, unknown)
                                 .lexically_normal()
                                 .string();
    return path.ends_with('/') ? path : path + '/';
}

}  // namespace

bool Diagnostics::FollowsFromMissingFile(const FileLoc &loc) const {
    return std::find(namingMissing.begin(), namingMissing.end(), loc) != namingMissing.end();
}

void Diagnostics::MissingFile(const FileLoc &loc, std::string_view name, std::string_view folder) {
    constexpr size_t kMostOfAFolder = 20;
    const std::filesystem::path inside = std::filesystem::path(name).parent_path();
    MissingFolder &of = missing[inside.string()];
    const bool isNew = of.names.emplace(name).second;
    if (isNew) of.lookedIn = {AbsoluteFolder(folder / inside)};
    if (const std::string here = AbsoluteFolder(inside); isNew && here != of.lookedIn[0])
        of.lookedIn.push_back(here);
    if (isNew && of.names.size() <= kMostOfAFolder)
        Error(loc, fmt::format("there is no file \"{}\"", Shortened(name, 300)));
    else
        ++errors;
    namingMissing.push_back(loc);
}

std::vector<std::string> Diagnostics::MissingFiles() const {
    std::vector<std::string> lines;
    for (const auto &[folder, of] : missing)
        lines.push_back(fmt::format(
            "{} file{} of {} {} missing; looked for in {}", of.names.size(),
            of.names.size() == 1 ? "" : "s", folder.empty() ? "the scene's folder" : folder + '/',
            of.names.size() == 1 ? "is" : "are", fmt::join(of.lookedIn, " and ")));
    return lines;
}

bool Diagnostics::NoteOldName(const OldName &name, const FileLoc &loc) {
    for (const OldNameUse &use : oldNames)
        if (use.name == &name) return false;
    oldNames.push_back({&name, loc});
    return true;
}

// --- Names ---

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
    if (const std::string upstream = PbrtHasIt(kind, name); !upstream.empty())
        return fmt::format("{} \"{}\": {}", kind, name, upstream);
    if (const OldName *const old = FindOldName(kind, name))
        return fmt::format("unknown {} \"{}\"; {}", kind, name, CalledNow(*old));
    const std::string hint = DidYouMean(name, known);
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
