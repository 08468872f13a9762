#include "pbrt/scene/params.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "pbrt/scene/param_types.h"
#include "pbrt/scene/scene_file.h"

namespace pbrt {
namespace {

size_t TokenCount(const ParsedParameter &p) {
    return p.floats.size() + p.ints.size() + p.strings.size() + p.bools.size();
}

/// Text that outlives the dictionary; types come from a fixed list.
std::string_view InternedType(std::string_view type) {
    const ParamType *const known = FindParamType(type);
    return known ? known->name : std::string_view();
}

}  // namespace

ParamDict::ParamDict(const ParsedParameters &params, FileLoc directive, std::string what,
                     const RGBColorSpace *colorSpace, Diagnostics *diagnostics, std::string dir)
    : params(params),
      used(params.size()),
      directive(directive),
      what(std::move(what)),
      colorSpace(colorSpace),
      diagnostics(diagnostics),
      dir(std::move(dir)) {
    constexpr size_t kMostPlugIns = 16;  // ask for fewer names
    asked.reserve(kMostPlugIns);
}

ParamDict::ParamDict(ParsedParameters &&given, FileLoc directive, std::string what,
                     const RGBColorSpace *colorSpace, Diagnostics *diagnostics, std::string dir)
    : own(std::make_shared<const ParsedParameters>(std::move(given))),
      params(*own),
      used(params.size()),
      directive(directive),
      what(std::move(what)),
      colorSpace(colorSpace),
      diagnostics(diagnostics),
      dir(std::move(dir)) {}

// --- Look-up ---

std::optional<size_t> ParamDict::FindLast(std::string_view name, Types types) const {
    for (const bool inherited : {false, true})
        for (size_t i = params.size(); i-- > 0;) {
            const ParsedParameter &p = params[i];
            if (p.mayBeUnused != inherited || p.name != name) continue;
            if (types.size() == 0 || std::find(types.begin(), types.end(), p.type) != types.end())
                return i;
        }
    return {};
}

void ParamDict::NoteRequest(std::string_view name, std::string_view type) {
    for (const Request &a : asked)
        if (a.name == name && a.type == type) return;
    asked.push_back({std::string(name), InternedType(type)});
}

const ParsedParameter *ParamDict::Find(std::string_view name, Types types) {
    for (const std::string_view type : types)
        NoteRequest(name, type);
    const std::optional<size_t> winner = FindLast(name, types);
    if (!winner) return nullptr;
    used[*winner] = true;
    return &params[*winner];
}

const ParsedParameter *ParamDict::FindOne(std::string_view name, std::string_view type,
                                          size_t items) {
    const ParsedParameter *const p = Find(name, {type});
    return p && CountIs(*p, items) ? p : nullptr;
}

bool ParamDict::CountIs(const ParsedParameter &p, size_t items) {
    const size_t count = TokenCount(p);
    if (count != 0 && count != items)
        ValueError(
            p, fmt::format("expected {} value{}, found {}", items, items == 1 ? "" : "s", count));
    return count == items;
}

const std::vector<float> *ParamDict::FindGroups(std::string_view name, std::string_view type,
                                                size_t items) {
    const ParsedParameter *const p = Find(name, {type});
    if (!p) return nullptr;
    if (p->floats.size() % items != 0)
        ValueError(*p, fmt::format("{} numbers are not a multiple of {}", p->floats.size(), items));
    return &p->floats;
}

bool ParamDict::Has(std::string_view name, std::string_view type) {
    NoteRequest(name, type);
    return (type.empty() ? FindLast(name, {}) : FindLast(name, {type})).has_value();
}

FileLoc ParamDict::Loc(std::string_view name) const {
    const std::optional<size_t> i = FindLast(name, {});
    return i ? params[*i].loc : directive;
}

// --- Single values ---

template <typename Number>
bool ParamDict::InRange(const ParsedParameter &p, Number value, Number lo, Number hi,
                        std::string_view unit) {
    if (value >= lo && value <= hi) return true;
    using Limits = std::numeric_limits<Number>;
    const auto isOpen = [](Number bound) {
        return bound <= Limits::lowest() || bound >= Limits::max();
    };
    std::string text = isOpen(hi)   ? fmt::format("{} is less than {}", value, lo)
                       : isOpen(lo) ? fmt::format("{} is more than {}", value, hi)
                                    : fmt::format("{} is outside [{}, {}]", value, lo, hi);
    if (!unit.empty()) text += fmt::format(" {}", unit);
    ValueError(p, text);
    return false;
}

float ParamDict::GetOneFloat(std::string_view name, float def) {
    const ParsedParameter *const p = FindOne(name, "float", 1);
    return p ? p->floats[0] : def;
}

float ParamDict::GetOneFloat(const FloatParam &row) {
    const ParsedParameter *const p = FindOne(row.name, "float", 1);
    return p && InRange(*p, p->floats[0], row.lo, row.hi, row.unit) ? p->floats[0] : row.def;
}

int ParamDict::GetOneInt(std::string_view name, int def) {
    const ParsedParameter *const p = FindOne(name, "integer", 1);
    return p ? p->ints[0] : def;
}

int ParamDict::GetOneInt(std::string_view name, int def, int lo, int hi) {
    const ParsedParameter *const p = FindOne(name, "integer", 1);
    return p && InRange(*p, p->ints[0], lo, hi, "") ? p->ints[0] : def;
}

bool ParamDict::GetOneBool(std::string_view name, bool def) {
    const ParsedParameter *const p = FindOne(name, "bool", 1);
    return p ? p->bools[0] != 0 : def;
}

std::string ParamDict::GetOneString(std::string_view name, std::string_view def) {
    const ParsedParameter *const p = FindOne(name, "string", 1);
    return p ? p->strings[0] : std::string(def);
}

int ParamDict::GetOneChoice(std::string_view name, std::string_view def,
                            std::span<const std::string_view> allowed) {
    const auto index = [&](std::string_view value) {
        return int(std::find(allowed.begin(), allowed.end(), value) - allowed.begin());
    };
    const ParsedParameter *const p = FindOne(name, "string", 1);
    if (!p) return index(def);
    const int choice = index(p->strings[0]);
    if (choice < int(allowed.size())) return choice;
    ValueError(*p, fmt::format("\"{}\" is not one of {}{}", p->strings[0], QuotedList(allowed),
                               DidYouMean(p->strings[0], allowed)));
    return index(def);
}

Point2f ParamDict::GetOnePoint2f(std::string_view name, Point2f def) {
    const ParsedParameter *const p = FindOne(name, "point2", 2);
    return p ? Point2f{p->floats[0], p->floats[1]} : def;
}

Point3f ParamDict::GetOnePoint3f(std::string_view name, Point3f def) {
    const ParsedParameter *const p = FindOne(name, "point3", 3);
    return p ? Point3f{p->floats[0], p->floats[1], p->floats[2]} : def;
}

Vector3f ParamDict::GetOneVector3f(std::string_view name, Vector3f def) {
    const ParsedParameter *const p = FindOne(name, "vector3", 3);
    return p ? Vector3f{p->floats[0], p->floats[1], p->floats[2]} : def;
}

std::optional<RGB> ParamDict::GetOneRGB(std::string_view name) {
    const ParsedParameter *const p = Find(name, {"rgb"});
    return p ? CheckedRGB(*p, Infinity) : std::nullopt;
}

std::optional<RGB> ParamDict::CheckedRGB(const ParsedParameter &p, float most) {
    if (!CountIs(p, 3)) return {};
    for (const float component : p.floats)
        if (!InRange(p, component, 0.f, most, "")) return {};
    return RGB{p.floats[0], p.floats[1], p.floats[2]};
}

std::string ParamDict::GetFileName(std::string_view name, std::string_view def) {
    const std::string given = GetOneString(name, def);
    return given.empty() ? given : ResolvePath(given, dir);
}

std::optional<std::string> ParamDict::GetTexture(std::string_view name) {
    NoteRequest(name, "texture");
    const std::optional<size_t> i =
        FindLast(name, {"texture", "float", "rgb", "spectrum", "blackbody"});
    if (!i || params[*i].type != "texture") return {};
    used[*i] = true;
    if (!CountIs(params[*i], 1)) return {};
    return params[*i].strings[0];
}

// --- Arrays ---

std::vector<float> ParamDict::GetFloatArray(std::string_view name) {
    const ParsedParameter *const p = Find(name, {"float"});
    return p ? p->floats : std::vector<float>();
}

std::vector<int> ParamDict::GetIntArray(std::string_view name) {
    const ParsedParameter *const p = Find(name, {"integer"});
    return p ? p->ints : std::vector<int>();
}

std::vector<std::string> ParamDict::GetStringArray(std::string_view name) {
    const ParsedParameter *const p = Find(name, {"string"});
    return p ? p->strings : std::vector<std::string>();
}

std::vector<Point2f> ParamDict::GetPoint2fArray(std::string_view name) {
    std::vector<Point2f> points;
    const std::vector<float> *const v = FindGroups(name, "point2", 2);
    if (!v) return points;
    points.reserve(v->size() / 2);
    for (size_t i = 0; i + 2 <= v->size(); i += 2)
        points.push_back({(*v)[i], (*v)[i + 1]});
    return points;
}

template <typename Value>
std::vector<Value> ParamDict::Triples(std::string_view name, std::string_view type) {
    std::vector<Value> values;
    const std::vector<float> *const v = FindGroups(name, type, 3);
    if (!v) return values;
    values.reserve(v->size() / 3);
    for (size_t i = 0; i + 3 <= v->size(); i += 3)
        values.push_back({(*v)[i], (*v)[i + 1], (*v)[i + 2]});
    return values;
}

std::vector<Point3f> ParamDict::GetPoint3fArray(std::string_view name) {
    return Triples<Point3f>(name, "point3");
}

std::vector<Vector3f> ParamDict::GetVector3fArray(std::string_view name) {
    return Triples<Vector3f>(name, "vector3");
}

std::vector<Normal3f> ParamDict::GetNormalArray(std::string_view name) {
    return Triples<Normal3f>(name, "normal");
}

}  // namespace pbrt
