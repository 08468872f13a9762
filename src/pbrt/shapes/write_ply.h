#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Triangles to be written, in the words of PlyMesh; what a mesh has not is empty.
struct PlyTriangles {
    std::span<const Point3f> p;
    std::span<const Normal3f> n;        ///< one a vertex
    std::span<const Point2f> uv;        ///< one a vertex
    std::span<const uint32_t> indices;  ///< three a triangle
    std::span<const int32_t> faces;     ///< one a triangle
};

/// A binary little-endian PLY file: x y z, nx ny nz, u v; vertex_indices, face_indices. `maker` is
/// the line of its comment. ReadPly gives the same bits back.
std::string PlyText(const PlyTriangles &mesh, std::string_view maker);

}  // namespace pbrt
