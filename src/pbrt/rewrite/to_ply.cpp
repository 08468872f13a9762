#include "pbrt/rewrite/to_ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "pbrt/scene/number.h"
#include "pbrt/shapes/write_ply.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/read_file.h"

namespace pbrt::rewrite {
namespace {

/// The mesh's arrays, each of which trianglemesh and plymesh read alike.
struct Arrays {
    std::vector<Point3f> p;
    std::vector<Normal3f> n;
    std::vector<Point2f> uv;
    std::vector<uint32_t> indices;
    std::vector<int32_t> faces;
};

/// Takes the parameter apart into T of `kItems` numbers each; false where it is not like that.
template <typename T, size_t kItems>
bool Take(Statement &s, std::string_view type, std::string_view name, std::vector<T> *array) {
    const Parameter *const p = s.Find(name);
    if (!p) return true;
    const std::optional<std::vector<float>> numbers = Numbers(*p);
    if (!numbers || p->type != type || numbers->size() % kItems != 0) return false;
    static_assert(sizeof(T) == kItems * sizeof(float));
    array->resize(numbers->size() / kItems);
    std::copy(numbers->begin(), numbers->end(), reinterpret_cast<float *>(array->data()));
    return true;
}

template <typename Int>
bool TakeIntegers(Statement &s, std::string_view name, std::vector<Int> *array) {
    const Parameter *const p = s.Find(name);
    if (!p) return true;
    for (const std::string &value : p->values) {
        const std::optional<int> number = ParseInt(value);
        if (!number) return false;
        array->push_back(Int(*number));
    }
    return p->type == "integer";
}

/// nullopt where the mesh is mistaken.
std::optional<Arrays> TakeArrays(Statement &s) {
    Arrays a;
    if (!Take<Point3f, 3>(s, "point3", "P", &a.p) || !Take<Normal3f, 3>(s, "normal", "N", &a.n) ||
        !Take<Point2f, 2>(s, "point2", "uv", &a.uv) || !TakeIntegers(s, "indices", &a.indices) ||
        !TakeIntegers(s, "faceIndices", &a.faces))
        return {};
    const size_t points = a.p.size(), triangles = a.indices.size() / 3;
    const bool fits =
        a.indices.size() % 3 == 0 && (a.n.empty() || a.n.size() == points) &&
        (a.uv.empty() || a.uv.size() == points) &&
        (a.faces.empty() || a.faces.size() == triangles) &&
        std::all_of(a.indices.begin(), a.indices.end(), [&](uint32_t i) { return i < points; });
    return fits ? std::optional(std::move(a)) : std::nullopt;
}

}  // namespace

ToPly::ToPly(Diagnostics *log) : log(log) {
    const char *const given = std::getenv("PLY_PREFIX");
    prefix = given && *given ? given : "mesh";
}

void ToPly::Apply(Statement *s) {
    constexpr size_t kFewest = 500;
    if (s->directive != "Shape" || Unquoted(s->arguments[0]) != "trianglemesh") return;
    const Parameter *const indices = s->Find("indices");
    if (!indices || indices->values.size() < kFewest || s->Find("S")) return;
    const std::optional<Arrays> a = TakeArrays(*s);
    if (!a) return log->Warning(s->loc, "a mistaken trianglemesh stays as it is");
    const std::optional<std::string> file =
        Write(PlyText({a->p, a->n, a->uv, a->indices, a->faces}, "pbrt --toply"), s->loc);
    if (!file) return;
    for (const char *const name : {"P", "N", "uv", "indices", "faceIndices"})
        s->Remove(name);
    s->arguments[0] = Quoted("plymesh");
    s->Add("string", "filename", {Quoted(*file)});
}

std::optional<std::string> ToPly::Write(const std::string &bytes, const FileLoc &loc) {
    while (true) {
        std::string name = fmt::format("{}_{:05}.ply", prefix, ++count);
        const std::string path = (std::filesystem::path(folder) / name).string();
        std::error_code unknown;
        if (std::filesystem::exists(path, unknown)) {
            if (ReadWholeFile(path, Pipes::Refused).bytes != bytes) continue;
        } else if (const auto why = WriteFileAtomically(path, bytes)) {
            log->Error(loc, *why);
            return {};
        }
        return name;
    }
}

}  // namespace pbrt::rewrite
