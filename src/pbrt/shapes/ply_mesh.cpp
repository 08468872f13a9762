#include "pbrt/shapes/ply_mesh.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/shapes/displacement.h"
#include "pbrt/shapes/place_mesh.h"
#include "pbrt/shapes/ply.h"
#include "pbrt/textures/texture.h"

namespace pbrt {
namespace {

constexpr StringParam kFileName{"filename", "", "the PLY file, which may be gzipped"};
constexpr FloatParam kDisplacement{
    "displacement", "", 0, -kOpen, kOpen, "how far vertices move along their normals, by uv"};
constexpr FloatParam kEdgeLength{
    "edgelength", "", 1, kAboveZero, kOpen, "longest edge of displaced triangles, in the world"};

/// The faces as triangles alone.
TriangleMesh Triangles(PlyMesh ply) {
    TriangleMesh mesh;
    mesh.indices = std::move(ply.triangles);
    mesh.faceIndices = std::move(ply.triangleFaces);
    const bool areNumbered = !mesh.faceIndices.empty() || !ply.quadFaces.empty();
    // As without displacement triangles and quads count from 0 each.
    if (!areNumbered && !ply.quads.empty())
        for (size_t i = 0; i < mesh.indices.size() / 3; ++i)
            mesh.faceIndices.push_back(int(i));
    for (size_t i = 0; i < ply.quads.size(); i += 4) {
        const uint32_t *q = &ply.quads[i];  // 00 10 01 11
        mesh.indices.insert(mesh.indices.end(), {q[0], q[1], q[3], q[0], q[3], q[2]});
        mesh.faceIndices.insert(mesh.faceIndices.end(), 2,
                                areNumbered ? ply.quadFaces[i / 4] : int(i / 4));
    }
    mesh.p = std::move(ply.p);
    mesh.n = std::move(ply.n);
    mesh.uv = std::move(ply.uv);
    return mesh;
}

/// Exporters give triangles without area normals that are not numbers. Such vertices get none (0):
/// they take no part in the interpolation. A warning names the first.
void DropBrokenNormals(std::vector<Normal3f> *normals, const std::string &fileName,
                       ParamDict &params) {
    size_t count = 0, first = 0;
    for (size_t i = 0; i < normals->size(); ++i) {
        Normal3f &n = (*normals)[i];
        if (std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z)) continue;
        n = {};
        if (count++ == 0) first = i;
    }
    if (count > 0)
        params.Warning(kFileName.name,
                       fmt::format("{}: {} of {} normals are not finite, the first is that of "
                                   "vertex {}; these vertices have none",
                                   fileName, count, normals->size(), first));
}

}  // namespace

std::vector<PlyFile::Mesh> PlyFile::Create(const ShapeArguments &a) {
    const std::string fileName = a.params.GetFileName(kFileName);
    if (fileName.empty()) {
        a.params.Error(fmt::format("{} needs \"string filename\"", a.params.What()));
        return {};
    }
    const FloatTexture displacement = GetFloatTexture(a.params, a.textures, kDisplacement);
    const float edgeLength = a.params.GetOneFloat(kEdgeLength);
    std::vector<Mesh> meshes;
    const auto fail = [&](std::string_view what) {
        a.params.Error(kFileName.name, fmt::format("{}: {}", fileName, what));
        return std::vector<Mesh>();
    };
    const auto place = [&](auto mesh) {
        const auto wrong = PlaceMesh(a.renderFromObject, a.entity.reverseOrientation, &mesh);
        if (!wrong) meshes.emplace_back(std::move(mesh));
        return wrong;
    };
    std::string problem;
    std::optional<PlyMesh> ply = ReadPly(fileName, &problem);
    if (!ply) return fail(problem);
    if (ply->otherFaces > 0)
        a.params.Warning(kFileName.name,
                         fmt::format("{}: {} faces have other than 3 or 4 corners and are left out",
                                     fileName, ply->otherFaces));
    DropBrokenNormals(&ply->n, fileName, a.params);
    if (ply->triangles.empty() && ply->quads.empty()) return fail("has no face of 3 or 4 corners");

    if (!displacement.IsConstant() || displacement.Constant() != 0) {
        TriangleMesh mesh = Triangles(*std::move(ply));
        if (const auto wrong = Displace(displacement, edgeLength, a.renderFromObject, &mesh))
            return fail(*wrong);
        if (const auto wrong = place(std::move(mesh))) return fail(*wrong);
        return meshes;
    }
    if (!ply->quads.empty()) {
        BilinearMesh mesh;
        mesh.indices = std::move(ply->quads);
        mesh.faceIndices = std::move(ply->quadFaces);
        const bool shared = !ply->triangles.empty();
        mesh.p = shared ? ply->p : std::move(ply->p);
        mesh.n = shared ? ply->n : std::move(ply->n);
        mesh.uv = shared ? ply->uv : std::move(ply->uv);
        if (const auto wrong = place(std::move(mesh))) return fail(*wrong);
    }
    if (!ply->triangles.empty()) {
        TriangleMesh mesh;
        mesh.indices = std::move(ply->triangles);
        mesh.faceIndices = std::move(ply->triangleFaces);
        mesh.p = std::move(ply->p);
        mesh.n = std::move(ply->n);
        mesh.uv = std::move(ply->uv);
        if (const auto wrong = place(std::move(mesh))) return fail(*wrong);
    }
    return meshes;
}

}  // namespace pbrt
