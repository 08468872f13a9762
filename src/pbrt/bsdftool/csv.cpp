#include "pbrt/bsdftool/csv.h"

#include "pbrt/util/parse_number.h"

namespace pbrt::bsdftool {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view Trimmed(std::string_view s) {
    const size_t first = s.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return s.substr(first, s.find_last_not_of(kBlanks) + 1 - first);
}

}  // namespace

std::vector<std::string_view> SplitCells(std::string_view text, char separator) {
    std::vector<std::string_view> cells;
    while (true) {
        const size_t end = text.find(separator);
        cells.push_back(Trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return cells;
        text.remove_prefix(end + 1);
    }
}

std::optional<double> ReadNumber(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    return ParseWhole<double>(text);
}

}  // namespace pbrt::bsdftool
