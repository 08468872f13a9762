#include "pbrt/shapes/parallelogram.h"

namespace pbrt {

std::optional<BilinearMesh> AsParallelogram(const TriangleMesh &mesh) {
    if (mesh.indices.size() != 6 || !mesh.n.empty()) return {};
    const uint32_t *i = mesh.indices.data();
    if (i[3] != i[0] || i[4] != i[2]) return {};
    const Point3f a = mesh.p[i[0]], b = mesh.p[i[1]], c = mesh.p[i[2]], d = mesh.p[i[5]];
    const float side = std::max(LengthSquared(b - a), LengthSquared(d - a));
    if (LengthSquared((c - b) - (d - a)) > 1e-10f * side) return {};
    BilinearMesh patch;
    patch.p = {a, b, d, c};
    patch.indices = {0, 1, 2, 3};
    patch.flipNormal = mesh.flipNormal;
    patch.planar = true;
    return patch;
}

}  // namespace pbrt
