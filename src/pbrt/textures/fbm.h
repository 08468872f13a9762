#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// Fractional Brownian motion: octaves of noise, signed, of the point in texture space;
/// see FBm in noise.h.
struct FBmTexture {
    static constexpr std::string_view kName = "fbm";
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"integer octaves\" 3 \"float roughness\" 0.8", "\"integer octaves\" 64"};
    static constexpr bool kIsFloatOnly = true;
    static FloatTexture CreateFloat(TextureBuilder &builder);
};
static_assert(TextureType<FBmTexture>);

}  // namespace pbrt
