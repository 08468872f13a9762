#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "pbrt/textures/texture.h"

namespace pbrt {

/// A float texture with a range. A constant outside it is an error when the scene is read; values
/// of a texture are clamped to it and counted in TextureEvalContext::clamped, those that are no
/// number count as the default.
class BoundedTexture {
  public:
    BoundedTexture() = default;
    BoundedTexture(ParamDict &params, const NamedTextures &named, const FloatParam &row)
        : texture(GetFloatTexture(params, named, row)) {
        if (!texture.IsConstant()) range = std::make_shared<const FloatParam>(row);
    }

    bool IsConstant() const { return texture.IsConstant(); }
    /// Only where IsConstant().
    float Constant() const { return texture.Constant(); }
    float Evaluate(const TextureEvalContext &ctx) const {
        return texture.IsConstant() ? texture.Constant() : Clamped(texture.Evaluate(ctx), ctx);
    }
    /// Adds a clause about the values that had to be clamped, if any, to `warnings`; `owner` is the
    /// material's name.
    void AddWarning(std::string_view owner, const ClampCounts &counts, std::string *warnings) const;

  private:
    float Clamped(float v, const TextureEvalContext &ctx) const {
        const float legal = std::clamp(v, range->lo, range->hi);
        if (v == legal) return v;
        if (ctx.clamped) ctx.clamped->Add(range.get());
        return legal == legal ? legal : range->def;
    }
    FloatTexture texture;
    std::shared_ptr<const FloatParam> range;  ///< null for constants, for materials may be many
};

}  // namespace pbrt
