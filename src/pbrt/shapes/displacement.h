#pragma once

#include <optional>
#include <string>

#include "pbrt/base/texture.h"
#include "pbrt/shapes/triangle_mesh.h"

namespace pbrt {

/// Cuts the triangles of a mesh in object space until no edge is longer than `edgeLength` in
/// rendering space, as far as floats have points between, moves each vertex along its unit normal by `height` at its uv, in object space,
/// and gives it the normal of the new surface. The mesh has uv. What is wrong, or nothing.
std::optional<std::string> Displace(const FloatTexture &height, float edgeLength,
                                    const Transform &renderFromObject, TriangleMesh *mesh);

}  // namespace pbrt
