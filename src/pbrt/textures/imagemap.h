#pragma once

#include "pbrt/textures/mapping2d.h"
#include "pbrt/textures/mipmap.h"
#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// An image laid over the surface: s to the right, t upwards, both 0 to 1. Values are times
/// `scale` and, with `invert`, taken from 1; never below 0, nor above 1 as an albedo. Floats are
/// the mean of R, G and B, or alpha, which is linear in every file, where the image has R, G, B
/// and an alpha that is not 1 everywhere.
struct ImageTexture {
    static constexpr std::string_view kName = "imagemap";
    static constexpr std::array<std::string_view, 2> kExamples{
        "\"string filename\" \"example.exr\"",
        "\"string filename\" \"example.exr\" \"string filter\" \"ewa\" \"string wrap\" \"clamp\" "
        "\"float scale\" 0.5"};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<ImageTexture>);

}  // namespace pbrt
