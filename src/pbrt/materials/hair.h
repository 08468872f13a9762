#pragma once

#include <array>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/hair_bxdf.h"
#include "pbrt/materials/bounded_texture.h"

namespace pbrt {

/// A dielectric fibre: `eta`, roughness along (`beta_m`) and around (`beta_n`) it, tilt of its
/// scales (`alpha`), and what it absorbs: `sigma_a` per fibre radius, else the colour of a mass of
/// such fibres (`reflectance` or `color`), else `eumelanin` and `pheomelanin`. Parameters of lower
/// rank than one that is given are ignored with a warning. The shape's v runs across the fibre, its
/// dp/du along it.
class HairMaterial {
  public:
    static constexpr std::string_view kName = "hair";
    static constexpr MaterialTraits kTraits{.fibre = true, .laidByUV = true, .warns = true};
    static constexpr std::array<std::string_view, 4> kExamples{
        "", "\"float eumelanin\" 8 \"float beta_m\" 0.2",
        "\"rgb reflectance\" [0.5 0.3 0.1] \"float beta_n\" 1",
        "\"rgb sigma_a\" [0 0 0] \"float alpha\" 0"};
    static HairMaterial Create(ParamDict &params, const NamedTextures &named);

    static constexpr std::string_view LaidByUV() { return "fibres"; }
    HairBxDF GetBxDF(const TextureEvalContext &ctx, const SampledWavelengths &lambda) const {
        const float beta_n = betaN.Evaluate(ctx);
        return HairBxDF(2 * ctx.uv.y - 1, eta.Evaluate(ctx), Absorption(ctx, lambda, beta_n),
                        betaM.Evaluate(ctx), beta_n, alpha.Evaluate(ctx));
    }
    /// A sentence where texture values had to be clamped; else empty.
    std::string Warnings(const ClampCounts &counts) const;

  private:
    enum class Pigment { SigmaA, Reflectance, Melanin };
    SampledSpectrum Absorption(const TextureEvalContext &ctx, const SampledWavelengths &lambda,
                               float beta_n) const;

    Pigment pigment = Pigment::Melanin;
    SpectrumTexture color;  ///< sigma_a or reflectance
    BoundedTexture eumelanin, pheomelanin;
    BoundedTexture eta, betaM, betaN, alpha;
};
static_assert(MaterialType<HairMaterial>);

}  // namespace pbrt
