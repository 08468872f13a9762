// OpenSubdiv, which Debian has, weighs vertices as Loop did, pbrt-v4 as Warren: its surfaces differ
// at every vertex that has not six neighbours. Hence loop_mesh.h.

#include "pbrt/shapes/loop_subdiv.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/shapes/loop_mesh.h"
#include "pbrt/shapes/mesh_reader.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr IntParam kLevels{"levels", 3, 0, 16, "times that each triangle is cut in four"};
constexpr StringParam kScheme{"scheme", "loop", "without effect, as in pbrt-v4"};

/// Why the triangles cannot be cut so often; empty where they can.
std::string Unfit(const std::vector<uint32_t> &indices, int levels) {
    for (size_t i = 0; i < indices.size(); i += 3)
        if (indices[i] == indices[i + 1] || indices[i] == indices[i + 2] ||
            indices[i + 1] == indices[i + 2])
            return fmt::format("triangle {} has a point twice", i / 3);
    const double triangles = std::ldexp(double(indices.size() / 3), 2 * levels);
    if (triangles > 0x1p30)
        return fmt::format("{:.0f} triangles are more than fit here", triangles);
    if (const auto why = WhyTooLarge(uint64_t(LoopMesh::BytesOf(triangles))))
        return fmt::format("a mesh of {:.0f} triangles {}", triangles, *why);
    return {};
}

}  // namespace

std::optional<TriangleMesh> LoopSubdivision::Create(const ShapeArguments &a) {
    MeshReader reader(a, 3);
    const int levels = a.params.GetOneInt(kLevels);
    a.params.GetOneString(kScheme);
    TriangleMesh control;
    if (!reader.PointsAndIndices(&control.p, &control.indices)) return {};
    if (const std::string why = Unfit(control.indices, levels); !why.empty()) {
        a.params.Error(MeshReader::kIndices.name, fmt::format("{}: {}", a.params.What(), why));
        return {};
    }
    LoopMesh loop(control.p, control.indices);
    for (int i = 0; i < levels; ++i)
        loop = loop.Subdivided();
    TriangleMesh mesh;
    mesh.indices = loop.Indices();
    for (uint32_t v = 0; v < uint32_t(loop.NVertices()); ++v) {
        mesh.p.push_back(loop.LimitPosition(v));
        mesh.n.push_back(loop.LimitNormal(v));
    }
    return reader.Finish(std::move(mesh));
}

}  // namespace pbrt
