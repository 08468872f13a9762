#pragma once

#include <optional>
#include <string>

#include "pbrt/util/transform.h"

namespace pbrt {

struct BilinearMesh;
struct TriangleMesh;

/// Moves a mesh in object space to rendering space, orients its normals, and leaves
/// kPointsBehindLast behind the last vertex. What is wrong with it, or nothing.
std::optional<std::string> PlaceMesh(const Transform &renderFromObject, bool reverseOrientation,
                                     TriangleMesh *mesh);
std::optional<std::string> PlaceMesh(const Transform &renderFromObject, bool reverseOrientation,
                                     BilinearMesh *mesh);

}  // namespace pbrt
