#include <fmt/format.h>

#include <limits>

#include "pbrt/cli/options.h"
#include "pbrt/plytool/commands.h"
#include "pbrt/plytool/read_mesh.h"
#include "pbrt/shapes/write_ply.h"
#include "pbrt/util/atomic_file.h"

namespace pbrt::plytool {
namespace {

struct Options {
    std::string file, outBase;
    int maxFaces = 1000000;
};

constexpr char kDescription[] =
    "Writes the triangles of a PLY file, in their order, into several: OUTBASE-001.ply and so on, "
    "each with the vertices that it needs.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "file", &o->file, "PLY file, gzipped or not");
    cli::AddRequired(app, "--outbase", &o->outBase, "beginning of the files' names");
    cli::AddNumber(app, "--maxfaces", &o->maxFaces, {.lo = 1},
                   "most triangles in a file (default 1000000)");
}

/// The text of a mesh of some of the triangles, three indices each.
std::string Part(const PlyMesh &mesh, std::span<const uint32_t> indices) {
    constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
    std::vector<uint32_t> newIndex(mesh.p.size(), kNone), part;
    std::vector<Point3f> p;
    std::vector<Normal3f> n;
    std::vector<Point2f> uv;
    for (const uint32_t i : indices) {
        if (newIndex[i] == kNone) {
            newIndex[i] = uint32_t(p.size());
            p.push_back(mesh.p[i]);
            if (!mesh.n.empty()) n.push_back(mesh.n[i]);
            if (!mesh.uv.empty()) uv.push_back(mesh.uv[i]);
        }
        part.push_back(newIndex[i]);
    }
    return PlyText({p, n, uv, part, {}}, "plytool split");
}

cli::Outcome WithOptions(Options &o) {
    const OrError<PlyMesh> read = ReadMesh(o.file);
    if (!read) return cli::Failure("plytool", read.error);
    const PlyMesh &mesh = *read.value;
    if (!mesh.quads.empty() || !mesh.triangleFaces.empty())
        return cli::Failure(
            "plytool", fmt::format("{}: only triangles without face indices can be split", o.file));
    const size_t most = 3 * size_t(o.maxFaces);
    std::string text;
    for (size_t first = 0, k = 1; first < mesh.triangles.size(); first += most, ++k) {
        const size_t count = std::min(most, mesh.triangles.size() - first);
        const std::string name = fmt::format("{}-{:03}.ply", o.outBase, k);
        const auto why =
            WriteFileAtomically(name, Part(mesh, std::span(mesh.triangles).subspan(first, count)));
        if (why) return cli::Failure("plytool", *why);
        text += fmt::format("{}: {} triangles\n", name, count / 3);
    }
    return {0, text, {}};
}

}  // namespace

cli::Outcome Split(cli::Args args) {
    return cli::RunWithOptions(args, "plytool split", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::plytool
