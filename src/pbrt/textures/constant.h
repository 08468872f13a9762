#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// The same `value` everywhere. Leaves no node behind.
struct ConstantTexture {
    static constexpr std::string_view kName = "constant";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"float value\" 0.3"};
    static FloatTexture CreateFloat(TextureBuilder &builder) {
        return builder.params.GetOneFloat("value", 1);
    }
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder) {
        return builder.Spectra("value", 1);
    }
};
static_assert(TextureType<ConstantTexture>);

}  // namespace pbrt
