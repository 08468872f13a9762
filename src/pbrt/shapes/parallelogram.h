#pragma once

#include <optional>

#include "pbrt/shapes/bilinear_mesh.h"
#include "pbrt/shapes/triangle_mesh.h"

namespace pbrt {

/// The one patch that a mesh of two triangles covers, with the same normal, if it is a
/// parallelogram without vertex normals (to 1e-5 of its sides) whose triangles are (a b c) and (a c
/// d).
std::optional<BilinearMesh> AsParallelogram(const TriangleMesh &mesh);

}  // namespace pbrt
