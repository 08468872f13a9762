#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// Unit squares (dimension 2: of the mapping's s and t) or cubes (dimension 3: of texture space)
/// in turn tex1 and tex2; tex1 where the sum of the cell's whole coordinates is even. In 2D the
/// mean over the box that holds the pixel's footprint; in 3D of the point alone.
struct CheckerboardTexture {
    static constexpr std::string_view kName = "checkerboard";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"integer dimension\" 3"};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<CheckerboardTexture>);

}  // namespace pbrt
