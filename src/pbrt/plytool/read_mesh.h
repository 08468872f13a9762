#pragma once

#include <string>

#include "pbrt/shapes/ply.h"
#include "pbrt/util/result.h"

namespace pbrt::plytool {

/// The mesh, or the sentence to fail with.
inline OrError<PlyMesh> ReadMesh(const std::string &file) {
    std::string problem;
    std::optional<PlyMesh> mesh = ReadPly(file, &problem);
    if (!mesh) return {{}, file + ": " + problem};
    return {std::move(mesh), {}};
}

}  // namespace pbrt::plytool
