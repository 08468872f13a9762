#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pbrt/util/vecmath.h"

namespace pbrt::feathergen {

/// Triangles with normals, uv and the face of the parameter texture each belongs to.
struct Mesh {
    std::vector<Point3f> p;
    std::vector<Normal3f> n;
    std::vector<Point2f> uv;        ///< per vertex, or empty
    std::vector<uint32_t> indices;  ///< three a triangle
    std::vector<int32_t> faces;     ///< per triangle, or empty

    size_t NTriangles() const { return indices.size() / 3; }
    void AddTriangle(uint32_t a, uint32_t b, uint32_t c) {
        indices.insert(indices.end(), {a, b, c});
    }
};

/// Binary little-endian PLY: x y z nx ny nz, u v where there are any; vertex_indices and, where
/// there are any, face_indices.
std::string ToPly(const Mesh &mesh);

}  // namespace pbrt::feathergen
