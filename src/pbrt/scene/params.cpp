#include "pbrt/scene/params.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "pbrt/scene/scene_file.h"
#include "pbrt/util/check.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 1> kTexture{"texture"};

size_t TokenCount(const ParsedParameter &p) {
    return p.floats.size() + p.ints.size() + p.strings.size() + p.bools.size();
}

/// True if both rows ask for values of the same types.
bool HaveSameTypes(const ParamRow &a, const ParamRow &b) {
    return a.index() == b.index() && TypesOf(a).front() == TypesOf(b).front();
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
    constexpr size_t kMostPlugIns = 12;  // ask for fewer
    requested.reserve(kMostPlugIns);
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

void ParamDict::NoteRequest(const ParamRow &row, bool texture) {
    const std::string_view name = NameOf(row);
    auto place = requested.end();
    for (auto known = requested.begin(); known != requested.end(); ++known) {
        if (NameOf(known->row) != name) continue;
        if (HaveSameTypes(known->row, row)) {
            known->texture |= texture;
            return;
        }
        place = known + 1;
    }
    requested.insert(place, {row, texture});
}

const ParsedParameter *ParamDict::Find(const ParamRow &row) {
    NoteRequest(row);
    const std::optional<size_t> winner = FindLast(NameOf(row), TypesOf(row));
    if (!winner) return nullptr;
    used[*winner] = true;
    return &params[*winner];
}

const ParsedParameter *ParamDict::FindOne(const ParamRow &row, size_t items) {
    const ParsedParameter *const p = Find(row);
    return p && CountIs(*p, items) ? p : nullptr;
}

bool ParamDict::CountIs(const ParsedParameter &p, size_t items) {
    const size_t count = TokenCount(p);
    if (count != 0 && count != items)
        ValueError(
            p, fmt::format("expected {} value{}, found {}", items, items == 1 ? "" : "s", count));
    return count == items;
}

const std::vector<float> *ParamDict::FindGroups(const ArrayParam &row, size_t items) {
    const ParsedParameter *const p = Find(row);
    if (!p) return nullptr;
    if (p->floats.size() % items != 0)
        ValueError(*p, fmt::format("{} numbers are not a multiple of {}", p->floats.size(), items));
    return &p->floats;
}

bool ParamDict::Has(const ParamRow &row) {
    NoteRequest(row);
    return FindLast(NameOf(row), TypesOf(row)).has_value();
}

bool ParamDict::HasOrTexture(const ParamRow &row) {
    NoteRequest(row, true);
    return FindLast(NameOf(row), kTexture) || FindLast(NameOf(row), TypesOf(row));
}

FileLoc ParamDict::Loc(std::string_view name) const {
    const std::optional<size_t> i = FindLast(name, {});
    return i ? params[*i].loc : directive;
}

// --- Single values ---

bool ParamDict::Allow(const ParsedParameter &p, const std::string &whyIllegal) {
    if (whyIllegal.empty()) return true;
    ValueError(p, whyIllegal);
    return false;
}

float ParamDict::GetOneFloat(const FloatParam &row) {
    const ParsedParameter *const p = FindOne(row, 1);
    return p && Allow(*p, WhyIllegal(p->floats[0], row)) ? p->floats[0] : row.def;
}

int ParamDict::GetOneInt(const IntParam &row) {
    const ParsedParameter *const p = FindOne(row, 1);
    return p && Allow(*p, WhyIllegal(p->ints[0], row)) ? p->ints[0] : row.def;
}

bool ParamDict::GetOneBool(const BoolParam &row) {
    const ParsedParameter *const p = FindOne(row, 1);
    return p ? p->bools[0] != 0 : row.def;
}

std::string ParamDict::GetOneString(const StringParam &row) {
    const ParsedParameter *const p = FindOne(row, 1);
    return p ? p->strings[0] : std::string(row.def);
}

int ParamDict::GetOneChoice(const ChoiceParam &row) {
    const auto index = [&](std::string_view value) {
        return int(std::find(row.allowed.begin(), row.allowed.end(), value) - row.allowed.begin());
    };
    const ParsedParameter *const p = FindOne(row, 1);
    if (!p) return index(row.def);
    const int choice = index(p->strings[0]);
    if (choice < int(row.allowed.size())) return choice;
    ValueError(*p, fmt::format("\"{}\" is not one of {}{}", p->strings[0], QuotedList(row.allowed),
                               DidYouMean(p->strings[0], row.allowed)));
    return index(row.def);
}

Point3f ParamDict::GetOnePoint3f(const PointParam &row) {
    DCHECK(row.type == "point3");
    const ParsedParameter *const p = FindOne(row, 3);
    return p ? Point3f{p->floats[0], p->floats[1], p->floats[2]}
             : Point3f{row.def[0], row.def[1], row.def[2]};
}

Vector3f ParamDict::GetOneVector3f(const PointParam &row) {
    DCHECK(row.type == "vector3");
    const ParsedParameter *const p = FindOne(row, 3);
    return p ? Vector3f{p->floats[0], p->floats[1], p->floats[2]}
             : Vector3f{row.def[0], row.def[1], row.def[2]};
}

std::optional<RGB> ParamDict::GetOneRGB(const SpectrumParam &row) {
    const ParsedParameter *const p = Find(row);
    return p && p->type == "rgb" ? CheckedRGB(*p, Infinity) : std::nullopt;
}

std::optional<RGB> ParamDict::CheckedRGB(const ParsedParameter &p, float most) {
    if (!CountIs(p, 3)) return {};
    for (const float component : p.floats)
        if (!Allow(p, WhyIllegal(component, {"", "", 0, 0, most, ""}))) return {};
    return RGB{p.floats[0], p.floats[1], p.floats[2]};
}

std::string ParamDict::GetFileName(const StringParam &row) {
    const std::string given = GetOneString(row);
    if (given.empty()) return given;
    std::string path = ResolvePath(given, dir);
    std::error_code unknown;
    if (std::filesystem::status(path, unknown).type() == std::filesystem::file_type::not_found)
        diagnostics->MissingFile(Loc(row.name), given, dir);
    return path;
}

std::optional<std::string> ParamDict::GetTexture(const ParamRow &row) {
    static constexpr std::array<std::string_view, 5> kRivals{"texture", "float", "rgb", "spectrum",
                                                             "blackbody"};
    NoteRequest(row, true);
    const std::optional<size_t> i = FindLast(NameOf(row), kRivals);
    if (!i || params[*i].type != "texture") return {};
    used[*i] = true;
    if (!CountIs(params[*i], 1)) return {};
    return params[*i].strings[0];
}

// --- Arrays ---

std::vector<float> ParamDict::GetFloatArray(const ArrayParam &row) {
    DCHECK(row.type == "float");
    const ParsedParameter *const p = Find(row);
    return p ? p->floats : std::vector<float>();
}

std::vector<int> ParamDict::GetIntArray(const ArrayParam &row) {
    DCHECK(row.type == "integer");
    const ParsedParameter *const p = Find(row);
    return p ? p->ints : std::vector<int>();
}

std::vector<std::string> ParamDict::GetStringArray(const ArrayParam &row) {
    DCHECK(row.type == "string");
    const ParsedParameter *const p = Find(row);
    return p ? p->strings : std::vector<std::string>();
}

std::vector<Point2f> ParamDict::GetPoint2fArray(const ArrayParam &row) {
    DCHECK(row.type == "point2");
    std::vector<Point2f> points;
    const std::vector<float> *const v = FindGroups(row, 2);
    if (!v) return points;
    points.reserve(v->size() / 2);
    for (size_t i = 0; i + 2 <= v->size(); i += 2)
        points.push_back({(*v)[i], (*v)[i + 1]});
    return points;
}

template <typename Value>
std::vector<Value> ParamDict::Triples(const ArrayParam &row) {
    std::vector<Value> values;
    const std::vector<float> *const v = FindGroups(row, 3);
    if (!v) return values;
    values.reserve(v->size() / 3);
    for (size_t i = 0; i + 3 <= v->size(); i += 3)
        values.push_back({(*v)[i], (*v)[i + 1], (*v)[i + 2]});
    return values;
}

std::vector<Point3f> ParamDict::GetPoint3fArray(const ArrayParam &row) {
    DCHECK(row.type == "point3");
    return Triples<Point3f>(row);
}

std::vector<Vector3f> ParamDict::GetVector3fArray(const ArrayParam &row) {
    DCHECK(row.type == "vector3");
    return Triples<Vector3f>(row);
}

std::vector<Normal3f> ParamDict::GetNormalArray(const ArrayParam &row) {
    DCHECK(row.type == "normal");
    return Triples<Normal3f>(row);
}

}  // namespace pbrt
