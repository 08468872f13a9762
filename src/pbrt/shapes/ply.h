#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// The faces of a PLY file, in its coordinates.
struct PlyMesh {
    std::vector<Point3f> p;
    std::vector<Normal3f> n;  ///< nx ny nz, or empty
    std::vector<Point2f> uv;  ///< u v, s t, texture_u texture_v or texture_s texture_t; or empty
    std::vector<uint32_t> triangles;            ///< 3 vertices each
    std::vector<uint32_t> quads;                ///< 4 vertices each, as patches: 00 10 01 11
    std::vector<int> triangleFaces, quadFaces;  ///< face_indices, or empty
    uint64_t otherFaces = 0;                    ///< left out: fewer than 3 corners or more than 4
};

/// Reads an ascii or binary file, gzipped or not. After an error nullopt, and `problem` says what
/// is wrong with the file. What is reserved ahead never exceeds what the file can hold.
///
/// Written by hand because Debian packages no library that reads PLY.
std::optional<PlyMesh> ReadPly(const std::string &fileName, std::string *problem);

}  // namespace pbrt
