#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// Round dots of `inside` on `outside`: of the unit squares about whole s and t more than a third
/// have one, of radius 0.35, moved at random within the square. Not filtered. pbrt-v4 (commit
/// 5f7a606) swaps the two parameters; here they mean what they say.
struct DotsTexture {
    static constexpr std::string_view kName = "dots";
    static constexpr std::array<std::string_view, 2> kExamples{"",
                                                               "\"string mapping\" \"spherical\""};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<DotsTexture>);

}  // namespace pbrt
