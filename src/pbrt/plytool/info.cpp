#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/plytool/commands.h"
#include "pbrt/plytool/read_mesh.h"

namespace pbrt::plytool {
namespace {

struct Options {
    std::vector<std::string> files;
};

constexpr char kDescription[] = "Tells what PLY meshes have.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->files, "PLY files, gzipped or not");
}

std::string Text(const std::string &file, const PlyMesh &mesh) {
    std::string text = fmt::format(
        "{}: {} vertices, {} triangles, {} quads\n  normals: {}, uv: {}, face indices: {}\n", file,
        mesh.p.size(), mesh.triangles.size() / 3, mesh.quads.size() / 4,
        mesh.n.empty() ? "no" : "yes", mesh.uv.empty() ? "no" : "yes",
        mesh.triangleFaces.empty() && mesh.quadFaces.empty() ? "no" : "yes");
    if (mesh.otherFaces > 0)
        text += fmt::format("  {} faces of fewer than 3 corners or more than 4 are left out\n",
                            mesh.otherFaces);
    if (mesh.p.empty()) return text;
    Point3f low = mesh.p[0], high = mesh.p[0];
    for (const Point3f &p : mesh.p)
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    return text + fmt::format("  bounds: ({}, {}, {}) to ({}, {}, {})\n", low.x, low.y, low.z,
                              high.x, high.y, high.z);
}

cli::Outcome WithOptions(Options &o) {
    std::string text;
    for (const std::string &file : o.files) {
        const OrError<PlyMesh> mesh = ReadMesh(file);
        if (!mesh) return cli::Failure("plytool", mesh.error);
        text += Text(file, *mesh.value);
    }
    return {0, text, {}};
}

}  // namespace

cli::Outcome Info(cli::Args args) {
    return cli::RunWithOptions(args, "plytool info", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::plytool
