#pragma once

#include <array>
#include <optional>

#include "pbrt/textures/texture.h"
#include "pbrt/util/transform.h"

namespace pbrt {

inline constexpr std::array<SpectrumType, 3> kSpectrumRoles{
    SpectrumType::Albedo, SpectrumType::Unbounded, SpectrumType::Illuminant};

/// What a texture class needs to make one texture: its parameters, the textures defined before,
/// and where it stands.
struct TextureBuilder {
    ParamDict &params;
    NamedTextures &named;
    Transform textureFromRender;
    bool readsUV = false;  ///< set where the texture looks at the surface's uv

    FloatTexture Float(std::string_view name, float def) {
        return GetFloatTexture(params, named, name, def);
    }
    /// The parameter in every role; `def` where not given.
    SpectrumByRole Spectra(std::string_view name, float def);
};

}  // namespace pbrt
