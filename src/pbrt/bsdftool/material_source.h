#pragma once

#include <optional>
#include <string>

#include "pbrt/materials/material.h"
#include "pbrt/textures/texture.h"

namespace pbrt::bsdftool {

/// A material by itself, read by the ordinary parser.
struct MaterialSource {
    std::string type;  ///< as in the directive
    Material material;
};

/// `source` is pbrt text (`Material "diffuse"`) or the name of a scene file, whose first material
/// is taken. Mistakes go to the log.
std::optional<MaterialSource> ReadMaterial(const std::string &source, Diagnostics &log);

}  // namespace pbrt::bsdftool
