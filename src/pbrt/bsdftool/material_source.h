#pragma once

#include <optional>
#include <string>

#include "pbrt/materials/materials.h"

namespace pbrt::bsdftool {

/// A material by itself, read by the ordinary parser.
struct MaterialSource {
    std::string type;  ///< as in the directive
    Material material;
};

/// `source` is pbrt text (`Material "diffuse"`) or the name of a scene file; its first material is
/// taken, or where `pick` is not empty the first of that name or type. Mistakes go to the log.
std::optional<MaterialSource> ReadMaterial(const std::string &source, const std::string &pick,
                                           Diagnostics &log);

/// Point at which textures are looked up: the middle of [0, 1]^2.
inline TextureEvalContext MiddleOfTexture() {
    TextureEvalContext ctx;
    ctx.uv = {0.5f, 0.5f};
    return ctx;
}

}  // namespace pbrt::bsdftool
