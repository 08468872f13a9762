#include "pbrt/scene/param_types.h"

#include <algorithm>
#include <array>

#include "pbrt/util/upstream.h"

namespace pbrt {
namespace {

constexpr std::array kTypes{
    ParamType{"float", ValueKind::Float, 1},     ParamType{"integer", ValueKind::Int, 1},
    ParamType{"string", ValueKind::String, 1},   ParamType{"point3", ValueKind::Float, 3},
    ParamType{"rgb", ValueKind::Float, 3},       ParamType{"bool", ValueKind::Bool, 1},
    ParamType{"texture", ValueKind::String, 1},  ParamType{"spectrum", ValueKind::FloatOrString, 1},
    ParamType{"blackbody", ValueKind::Float, 1}, ParamType{"point2", ValueKind::Float, 2},
    ParamType{"vector2", ValueKind::Float, 2},   ParamType{"vector3", ValueKind::Float, 3},
    ParamType{"normal", ValueKind::Float, 3},
};

constexpr std::array<std::string_view, kTypes.size()> kNames = [] {
    std::array<std::string_view, kTypes.size()> names;
    std::transform(kTypes.begin(), kTypes.end(), names.begin(), [](ParamType t) { return t.name; });
    return names;
}();

struct Renamed {
    std::string_view was, is;
};
/// Types of no pbrt that people write all the same.
constexpr std::array kRenamed{Renamed{"normal3", "normal"}, Renamed{"int", "integer"},
                              Renamed{"boolean", "bool"}};

}  // namespace

const ParamType *FindParamType(std::string_view name) {
    const auto *const found =
        std::find_if(kTypes.begin(), kTypes.end(), [&](ParamType t) { return t.name == name; });
    return found == kTypes.end() ? nullptr : &*found;
}

std::span<const std::string_view> ParamTypeNames() {
    return kNames;
}

std::string_view NewNameOfType(std::string_view name) {
    if (const OldName *const old = FindOldName("parameter type", name)) return old->is;
    for (const Renamed &r : kRenamed)
        if (r.was == name) return r.is;
    return {};
}

Declaration SplitDeclaration(std::string_view text) {
    size_t next = 0;
    const auto isBlank = [&] { return text[next] == ' ' || text[next] == '\t'; };
    const auto readWord = [&] {
        while (next < text.size() && isBlank())
            ++next;
        const size_t start = next;
        while (next < text.size() && !isBlank())
            ++next;
        return text.substr(start, next - start);
    };
    Declaration d;
    d.type = readWord();
    d.name = readWord();
    if (!readWord().empty()) d.name = {};  // a third word
    return d;
}

}  // namespace pbrt
