#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// (1 - amount) tex1 + amount tex2. Constants are mixed when built.
struct MixTexture {
    static constexpr std::string_view kName = "mix";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"float amount\" 0.25"};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<MixTexture>);

FloatTexture Mixed(const FloatTexture &tex1, const FloatTexture &tex2, const FloatTexture &amount);
/// Constant spectra of different form meet in a table at whole nm.
SpectrumTexture Mixed(const SpectrumTexture &tex1, const SpectrumTexture &tex2,
                      const FloatTexture &amount);
/// Role by role, where both exist.
SpectrumByRole Mixed(const SpectrumByRole &tex1, const SpectrumByRole &tex2,
                     const FloatTexture &amount);

}  // namespace pbrt
