#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// `tex` times `scale`. Constants are multiplied when built.
struct ScaleTexture {
    static constexpr std::string_view kName = "scale";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"float scale\" 0.25"};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<ScaleTexture>);

FloatTexture Scaled(const FloatTexture &texture, const FloatTexture &scale);
SpectrumTexture Scaled(const SpectrumTexture &texture, const FloatTexture &scale);

}  // namespace pbrt
