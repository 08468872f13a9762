#include "pbrt/reference/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace pbrt::reference {
namespace {

constexpr std::string_view kNone = "no parameters\n";
constexpr size_t kColumns = 5;
using Cells = std::array<std::string, kColumns>;

const Cells &Titles() {
    static const Cells titles{"name", "type", "unit", "default", "range"};
    return titles;
}

Cells CellsOf(const RequestedParam &param) {
    return {std::string(NameOf(param.row)), TypesOf(param), std::string(UnitOf(param.row)),
            DefaultOf(param.row), RangeOf(param.row)};
}

std::array<size_t, kColumns> Widths(std::span<const RequestedParam> params) {
    std::array<size_t, kColumns> widths{};
    const auto grow = [&](const Cells &cells) {
        for (size_t i = 0; i < kColumns; ++i)
            widths[i] = std::max(widths[i], cells[i].size());
    };
    grow(Titles());
    for (const RequestedParam &param : params)
        grow(CellsOf(param));
    return widths;
}

std::string Line(const Cells &cells, const std::array<size_t, kColumns> &widths) {
    std::string line;
    for (size_t i = 0; i < kColumns; ++i)
        line += fmt::format("{:<{}}", cells[i], widths[i] + 2);
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

}  // namespace

std::string Call(const Family &family, std::string_view type) {
    return fmt::format("{} \"{}\"", family.directive, type);
}

std::string TextTable(std::span<const RequestedParam> params) {
    if (params.empty()) return std::string(kNone);
    const std::array<size_t, kColumns> widths = Widths(params);
    std::string text = Line(Titles(), widths);
    for (const RequestedParam &param : params)
        text += Line(CellsOf(param), widths) +
                fmt::format("{:{}}{}\n", "", widths[0] + 2, DocOf(param.row));
    return text;
}

std::string MarkdownHeading(int level, std::string_view title) {
    std::string text = fmt::format("\n{:#>{}} {}\n\n", "", level, title);
    char &first = text[size_t(level) + 2];
    first = char(std::toupper(static_cast<unsigned char>(first)));
    return text;
}

std::string MarkdownTable(std::span<const RequestedParam> params) {
    if (params.empty()) return std::string(kNone);
    std::string text =
        "| name | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";
    for (const RequestedParam &param : params) {
        Cells cells = CellsOf(param);
        cells[0] = fmt::format("`{}`", cells[0]);
        text += fmt::format("| {} | {} |\n", fmt::join(cells, " | "), DocOf(param.row));
    }
    return text;
}

}  // namespace pbrt::reference
