#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/plytool/commands.h"
#include "pbrt/plytool/read_mesh.h"

namespace pbrt::plytool {
namespace {

struct Options {
    std::vector<std::string> files;
};

constexpr char kDescription[] =
    "Prints PLY meshes as text: Shape \"trianglemesh\" and Shape \"bilinearmesh\", which a scene "
    "file "
    "may hold.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->files, "PLY files, gzipped or not");
}

template <int kCount, typename V>
std::string Vectors(std::string_view declaration, const std::vector<V> &values) {
    if (values.empty()) return {};
    std::string text = fmt::format("    \"{}\" [", declaration);
    for (const V &v : values)
        for (int c = 0; c < kCount; ++c)
            text += fmt::format(" {}", v[c]);
    return text + " ]\n";
}

template <typename Int>
std::string Integers(std::string_view name, const std::vector<Int> &values) {
    if (values.empty()) return {};
    std::string text = fmt::format("    \"integer {}\" [", name);
    for (const Int i : values)
        text += fmt::format(" {}", i);
    return text + " ]\n";
}

std::string ShapeText(std::string_view type, const PlyMesh &mesh,
                      const std::vector<uint32_t> &indices, const std::vector<int> &faces) {
    if (indices.empty()) return {};
    return fmt::format("Shape \"{}\"\n", type) + Integers("indices", indices) +
           Vectors<3>("point3 P", mesh.p) + Vectors<3>("normal N", mesh.n) +
           Vectors<2>("point2 uv", mesh.uv) + Integers("faceIndices", faces);
}

cli::Outcome WithOptions(Options &o) {
    std::string text;
    for (const std::string &file : o.files) {
        const OrError<PlyMesh> mesh = ReadMesh(file);
        if (!mesh) return cli::Failure("plytool", mesh.error);
        text += ShapeText("trianglemesh", *mesh.value, mesh.value->triangles,
                          mesh.value->triangleFaces);
        text += ShapeText("bilinearmesh", *mesh.value, mesh.value->quads, mesh.value->quadFaces);
    }
    return {0, text, {}};
}

}  // namespace

cli::Outcome Cat(cli::Args args) {
    return cli::RunWithOptions(args, "plytool cat", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::plytool
