#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "pbrt/textures/texture.h"

namespace pbrt {

/// A float texture with a range. A constant outside it is an error when the scene is read; values
/// of a texture are clamped to it and counted, those that are no number count as the default.
class BoundedTexture {
  public:
    BoundedTexture() = default;
    BoundedTexture(ParamDict &params, const NamedTextures &named, const FloatParam &row)
        : texture(GetFloatTexture(params, named, row)) {
        if (!texture.IsConstant()) range = std::make_shared<Range>(row);
    }

    bool IsConstant() const { return texture.IsConstant(); }
    /// Only where IsConstant().
    float Constant() const { return texture.Constant(); }
    float Evaluate(const TextureEvalContext &ctx) const {
        return texture.IsConstant() ? texture.Constant() : Clamped(texture.Evaluate(ctx));
    }
    /// Adds a clause about the values that had to be clamped, if any, to `remarks`; `owner` is the
    /// material's name.
    void AddRemark(std::string_view owner, std::string *remarks) const;

  private:
    struct Range {
        FloatParam row;
        std::atomic<int64_t> clamped{0};  ///< values so far

        explicit Range(const FloatParam &row) : row(row) {}
    };
    float Clamped(float v) const {
        const FloatParam &row = range->row;
        const float legal = std::clamp(v, row.lo, row.hi);
        if (v == legal) return v;
        range->clamped.fetch_add(1, std::memory_order_relaxed);
        return legal == legal ? legal : row.def;
    }
    FloatTexture texture;
    std::shared_ptr<Range> range;  ///< null for constants, for materials may be many
};

}  // namespace pbrt
