#pragma once

#include "pbrt/shapes/ply.h"
#include "pbrt/shapes/ply_values.h"

namespace pbrt {

/// Reads the element "vertex": x y z, and nx ny nz and a pair of uv where they are there; the rest
/// is passed over. False after an error.
bool ReadPlyVertices(const PlyElement &e, PlyValues &values, PlyMesh *mesh, std::string *problem);

}  // namespace pbrt
