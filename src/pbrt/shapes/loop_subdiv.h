#pragma once

#include <optional>
#include <string_view>

#include "pbrt/shapes/triangle_mesh.h"

namespace pbrt {

/// `Shape "loopsubdiv"`: a control mesh of triangles that becomes a finer one, its vertices and
/// normals those of the subdivision surface; no shape by itself.
struct LoopSubdivision {
    static constexpr std::string_view kName = "loopsubdiv";
    static std::optional<TriangleMesh> Create(const ShapeArguments &a);
};

}  // namespace pbrt
