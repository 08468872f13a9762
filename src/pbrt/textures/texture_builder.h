#pragma once

#include <array>
#include <optional>
#include <span>

#include "pbrt/textures/texture.h"
#include "pbrt/util/transform.h"

namespace pbrt {

inline constexpr std::array<SpectrumType, 3> kSpectrumRoles{
    SpectrumType::Albedo, SpectrumType::Unbounded, SpectrumType::Illuminant};

/// Input from which a texture class makes one texture: its parameters, the textures defined
/// before, and its place.
struct TextureBuilder {
    ParamDict &params;
    NamedTextures &named;
    Transform textureFromRender;
    bool readsUV = false;  ///< set where the texture looks at the surface's uv

    FloatTexture Float(const FloatParam &row) { return GetFloatTexture(params, named, row); }
    /// The parameter in every role (the row's is not looked at); the row's default where not given.
    SpectrumByRole Spectra(SpectrumParam row);
};

}  // namespace pbrt
