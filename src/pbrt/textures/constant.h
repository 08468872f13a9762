#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// The same `value` everywhere. Leaves no node behind.
struct ConstantTexture {
    static constexpr std::string_view kName = "constant";
    static constexpr std::array<std::string_view, 1> kExamples{""};
    static constexpr FloatParam kValue{"value", "", 1, -kOpen, kOpen, "the texture's value"};
    static constexpr SpectrumParam kSpectrum{"value", SpectrumType::Unbounded, "1",
                                             "the texture's value"};
    static FloatTexture CreateFloat(TextureBuilder &builder) {
        return builder.params.GetOneFloat(kValue);
    }
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder) {
        return builder.Spectra(kSpectrum);
    }
};
static_assert(TextureType<ConstantTexture>);

}  // namespace pbrt
