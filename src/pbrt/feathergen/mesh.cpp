#include "pbrt/feathergen/mesh.h"

#include "pbrt/shapes/write_ply.h"

namespace pbrt::feathergen {

std::string ToPly(const Mesh &mesh) {
    return PlyText({mesh.p, mesh.n, mesh.uv, mesh.indices, mesh.faces}, "feathergen");
}

}  // namespace pbrt::feathergen
