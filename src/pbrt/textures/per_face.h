#pragma once

#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// A Ptex file: each face of a mesh has its own texels over (u, v) in [0, 1]^2, or u + v <= 1 in
/// files for triangles. The face is the mesh's face index, else the primitive's number; where the
/// file has no such face the value is 0. Looked-up values are decoded by `encoding`, "gamma 2.2"
/// where not given, and are times `scale`. Files of one channel (or one and alpha) are grey, of
/// others the first three are R, G, B (sRGB primaries), of which floats are the mean. Colors are
/// never below 0, nor above 1 as an albedo. Filtered as PtexTexture::Lookup says, over the box that
/// holds the pixel's footprint.
struct PerFaceTexture {
    static constexpr std::string_view kName = "ptex";
    static constexpr std::array<std::string_view, 1> kExamples{
        "\"string filename\" \"example.ptx\""};
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};
static_assert(TextureType<PerFaceTexture>);

}  // namespace pbrt
