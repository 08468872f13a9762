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
    std::vector<std::string_view> known, expected;
    for (const RequestedParam &r : requested) {
        const std::string_view name = NameOf(r.row);
        if (known.empty() || known.back() != name) known.push_back(name);
        if (name != p.name) continue;
        if (r.texture) expected.insert(expected.begin(), "texture");
        const Types types = TypesOf(r.row);
        expected.insert(expected.end(), types.begin(), types.end());
    }
    if (std::find(expected.begin(), expected.end(), p.type) != expected.end())
        return diagnostics->Error(p.loc, fmt::format("\"{}\" has no effect here", given));
    if (!expected.empty()) {
        std::vector<std::string> declarations;
        for (const std::string_view type : expected)
            declarations.push_back(fmt::format("{} {}", type, p.name));
        const std::vector<std::string_view> all(declarations.begin(), declarations.end());
        return diagnostics->Error(p.loc,
                                  fmt::format("\"{}\": expected {}", given, QuotedList(all)));
    }
    if (const std::string upstream = PbrtHasIt(what, p.name); !upstream.empty())
        return diagnostics->Error(p.loc,
                                  fmt::format("parameter \"{}\" of {}: {}", given, what, upstream));
    const std::string unknown = fmt::format("unknown parameter \"{}\" of {}", given, what);
    if (known.empty()) return diagnostics->Error(p.loc, unknown + ", which takes none");
    const OldName *const old = FindOldName("parameter", p.name);
    const std::string hint =
        old ? fmt::format("; pbrt-v4 calls it \"{}\";", old->is) : DidYouMean(p.name, known);
    diagnostics->Error(p.loc, fmt::format("{}{} known: {}", unknown, hint.empty() ? ";" : hint,
                                          fmt::join(known, ", ")));
}

}  // namespace pbrt
