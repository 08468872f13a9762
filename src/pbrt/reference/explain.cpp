#include "pbrt/reference/explain.h"

#include <algorithm>

#include "pbrt/reference/families.h"
#include "pbrt/reference/layout.h"
#include "pbrt/scene/description.h"

namespace pbrt::reference {
namespace {

constexpr std::string_view kAll = "all", kOption = "option";

std::vector<RequestedParam> Options() {
    std::vector<RequestedParam> rows;
    for (const ParamRow &row : OptionRows())
        rows.push_back({row});
    return rows;
}

std::string Manual() {
    std::string text =
        "# Parameters\n\nWritten by `pbrt --explain all > docs/REFERENCE.md`, which asks the "
        "plug-ins themselves; a test compares.\n`pbrt --explain \"material featherbarbule\"` "
        "prints a part of it. What exists beside parameters is in\n"
        "[COMPATIBILITY.md](COMPATIBILITY.md).\n\nRanges hold for what the scene file gives; "
        "values of textures are clamped to them. Spectra are given as\n`rgb`, `spectrum` or "
        "`blackbody`.\n";
    for (const Family &family : Families()) {
        text += MarkdownHeading(2, family.name);
        for (const std::string_view type : family.types())
            text +=
                MarkdownHeading(3, Call(family, type)) + MarkdownTable(ParametersOf(family, type));
    }
    return text + MarkdownHeading(2, kOption) + MarkdownTable(Options());
}

/// Without blanks and quotes around it.
std::string_view Trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(" \"");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \"") - first + 1);
}

std::string List(std::span<const std::string_view> names) {
    std::string text;
    for (const std::string_view name : names)
        text.append(name) += '\n';
    return text;
}

Explanation ExplainFamily(const Family &family, std::string_view type) {
    const std::vector<std::string_view> types = family.types();
    if (type.empty()) return {List(types), {}};
    if (std::find(types.begin(), types.end(), type) == types.end())
        return {{}, UnknownName(family.name, type, types)};
    return {Call(family, type) + "\n\n" + TextTable(ParametersOf(family, type)), {}};
}

}  // namespace

Explanation Explain(std::string_view what) {
    what = Trimmed(what);
    if (what == kAll) return {Manual(), {}};
    const std::string_view first = what.substr(0, what.find_first_of(" \""));
    if (first == kOption) return {TextTable(Options()), {}};
    std::vector<std::string_view> names;
    for (const Family &family : Families()) {
        names.push_back(family.name);
        if (!what.starts_with(family.name)) continue;
        const std::string_view rest = what.substr(family.name.size());
        if (rest.empty() || rest.front() == ' ' || rest.front() == '"')
            return ExplainFamily(family, Trimmed(rest));
    }
    names.insert(names.end(), {kOption, kAll});
    return {{}, UnknownName("family", first, names)};
}

}  // namespace pbrt::reference
