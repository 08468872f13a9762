// Messages of ParamDict, and what is left unread.

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/scene/params.h"
#include "pbrt/util/upstream.h"

namespace pbrt {

void ParamDict::Error(std::string_view name, std::string_view message) {
    diagnostics->Error(Loc(name), message);
}

void ParamDict::Warning(std::string_view name, std::string_view message) {
    diagnostics->Warning(Loc(name), message);
}

void ParamDict::WarningOnce(std::string_view name, std::string_view message) {
    diagnostics->WarningOnce(Loc(name), message);
}

void ParamDict::Error(std::string_view message) {
    diagnostics->Error(directive, message);
}

void ParamDict::ValueError(const ParsedParameter &p, std::string_view message) {
    diagnostics->Error(p.valueLoc, fmt::format("\"{} {}\": {}", p.type, p.name, message));
}

void ParamDict::ReportUnused() {
    for (size_t i = 0; i < params.size(); ++i)
        if (!used[i] && !params[i].mayBeUnused) ReportUnused(params[i], i);
}

void ParamDict::ReportUnused(const ParsedParameter &p, size_t index) {
    const std::string given = fmt::format("{} {}", p.type, p.name);
    for (size_t i = index + 1; i < params.size(); ++i) {
        const ParsedParameter &later = params[i];
        if (later.mayBeUnused || later.name != p.name || (later.type != p.type && !used[i]))
            continue;
        if (later.type == p.type) return;  // overridden, and reported there if unused
        return diagnostics->Error(
            p.loc, fmt::format("\"{}\" has no effect: the later \"{} {}\" counts", given,
                               later.type, later.name));
    }
    std::vector<std::string> expected;
    std::vector<std::string_view> known;
    bool inAnyType = false;
    for (const Request &a : asked) {
        if (std::find(known.begin(), known.end(), a.name) == known.end()) known.push_back(a.name);
        if (a.name != p.name) continue;
        if (a.type == p.type)
            return diagnostics->Error(p.loc, fmt::format("\"{}\" has no effect here", given));
        inAnyType |= a.type.empty();
        if (!a.type.empty()) expected.push_back(fmt::format("{} {}", a.type, a.name));
    }
    if (!expected.empty()) {
        const std::vector<std::string_view> names(expected.begin(), expected.end());
        return diagnostics->Error(p.loc,
                                  fmt::format("\"{}\": expected {}", given, QuotedList(names)));
    }
    if (inAnyType)
        return diagnostics->Error(p.loc, fmt::format("\"{}\" has no effect here", given));
    const std::string unknown = fmt::format("unknown parameter \"{}\" of {}", given, what);
    if (known.empty()) return diagnostics->Error(p.loc, unknown + ", which takes none");
    const std::string upstream = PbrtHasIt(what, p.name);
    const std::string hint = upstream.empty() ? DidYouMean(p.name, known) : upstream + ';';
    diagnostics->Error(p.loc, fmt::format("{}{} known: {}", unknown, hint.empty() ? ";" : hint,
                                          fmt::join(known, ", ")));
}

}  // namespace pbrt
