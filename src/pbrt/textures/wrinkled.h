#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// Octaves of the absolute value of noise, which is creased where it is 0, of the point in texture
/// space; see Turbulence in noise.h.
struct WrinkledTexture {
    static constexpr std::string_view kName = "wrinkled";
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"integer octaves\" 3 \"float roughness\" 0.8", "\"integer octaves\" 64"};
    static constexpr bool kIsFloatOnly = true;
    static FloatTexture CreateFloat(TextureBuilder &builder);
};
static_assert(TextureType<WrinkledTexture>);

}  // namespace pbrt
