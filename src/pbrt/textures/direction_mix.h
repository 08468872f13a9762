#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// amount tex1 + (1 - amount) tex2, where amount is |cosine| between the surface's normal and
/// `dir`, which the texture's place turns.
struct DirectionMixTexture {
    static constexpr std::string_view kName = "directionmix";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"vector3 dir\" [ 1 2 -3 ]"};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<DirectionMixTexture>);

}  // namespace pbrt
