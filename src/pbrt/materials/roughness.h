#pragma once

#include "pbrt/materials/bounded_texture.h"

namespace pbrt {

/// The parameters of one surface's roughness.
struct RoughnessRows {
    FloatParam both, u, v;
};
/// `roughness`, `uroughness` and `vroughness`.
extern const RoughnessRows kRoughnessRows;

/// `roughness`, `uroughness`, `vroughness` and `remaproughness` of pbrt's microfacet materials.
struct Roughness {
    BoundedTexture u, v;
    bool remap = true;

    static Roughness Create(ParamDict &params, const NamedTextures &named,
                            const RoughnessRows &rows = kRoughnessRows);
    /// Microfacet alpha along x and y: the square root of the roughness where `remaproughness`.
    Vector2f Alpha(const TextureEvalContext &ctx) const {
        const float a = u.Evaluate(ctx), b = v.Evaluate(ctx);
        return remap ? Vector2f{std::sqrt(a), std::sqrt(b)} : Vector2f{a, b};
    }
    /// The same everywhere and in every direction.
    bool IsUniform() const {
        return u.IsConstant() && v.IsConstant() && u.Constant() == v.Constant();
    }
    /// See MaterialTraits::laidByUV.
    std::string_view LaidByUV() const {
        const bool differ = u.IsConstant() && v.IsConstant() && u.Constant() != v.Constant();
        return differ ? "directions of roughness" : "";
    }
    /// See MaterialTraits::warns.
    std::string Warnings(std::string_view owner, const ClampCounts &counts) const;
};

}  // namespace pbrt
