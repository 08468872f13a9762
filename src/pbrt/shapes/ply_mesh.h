#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "pbrt/shapes/bilinear_mesh.h"
#include "pbrt/shapes/triangle_mesh.h"

namespace pbrt {

/// `Shape "plymesh"`: a file whose faces become meshes; no shape by itself.
struct PlyFile {
    static constexpr std::string_view kName = "plymesh";
    using Mesh = std::variant<BilinearMesh, TriangleMesh>;
    /// Two where the file has both triangles and quads; none after an error.
    static std::vector<Mesh> Create(const ShapeArguments &a);
};

}  // namespace pbrt
