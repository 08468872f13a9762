#pragma once

#include <variant>

#include "pbrt/textures/mapping2d.h"
#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// Unit squares (dimension 2: of the mapping's s and t) or cubes (dimension 3: of texture space)
/// in turn tex1 and tex2; tex1 where the sum of the cell's whole coordinates is even.
struct CheckerboardTexture {
    static constexpr std::string_view kName = "checkerboard";
    static FloatTexture CreateFloat(TextureBuilder &builder);
    static SpectrumByRole CreateSpectrum(TextureBuilder &builder);
};

/// Share of tex2 at a point, 0 to 1.
class Checkerboard {
  public:
    static Checkerboard Create(TextureBuilder &builder);
    explicit Checkerboard(TextureMapping2D mapping) : space(std::move(mapping)) {}
    explicit Checkerboard(const Transform &textureFromRender) : space(textureFromRender) {}
    /// In 2D the mean over the box that holds the pixel's footprint; in 3D of the point alone.
    float Second(const TextureEvalContext &ctx) const;

  private:
    std::variant<TextureMapping2D, Transform> space;
};

}  // namespace pbrt
