#pragma once

#include <memory>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/coated_diffuse_bxdf.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// A diffuse base (`reflectance`, default 0.5) under a dielectric coat: `eta` (a number, or a
/// spectrum that is the same everywhere, >= 1), `thickness` (its optical depth at normal incidence;
/// a number), roughness as in Roughness. The coat only absorbs: `albedo` must be 0. `g`, `maxdepth`
/// and `nsamples` are read and have no effect, for nothing is left to chance.
struct CoatedDiffuseMaterial {
    static constexpr std::string_view kName = "coateddiffuse";
    static constexpr MaterialTraits kTraits{.canBeUniform = true, .laidByUV = true, .warns = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"rgb reflectance\" [0.9 0.5 0.1] \"float roughness\" 0.3 \"float eta\" 1.3",
        "\"float thickness\" 0 \"float uroughness\" 0.01 \"float vroughness\" 0.2"};
    SpectrumTexture reflectance;
    Roughness roughness;
    std::shared_ptr<const Coat> coat;

    static CoatedDiffuseMaterial Create(ParamDict &params, const NamedTextures &named);
    bool IsUniform() const { return reflectance.IsConstant() && roughness.IsUniform(); }
    CoatedDiffuseBxDF GetBxDF(const TextureEvalContext &ctx,
                              const SampledWavelengths &lambda) const {
        const Vector2f alpha = roughness.Alpha(ctx);
        return CoatedDiffuseBxDF(ClampToUnit(reflectance.Evaluate(ctx, lambda)), *coat, alpha.x,
                                 alpha.y);
    }
    std::string_view LaidByUV() const { return roughness.LaidByUV(); }
    std::string Warnings(const ClampCounts &counts) const {
        return roughness.Warnings(kName, counts);
    }
};
static_assert(MaterialType<CoatedDiffuseMaterial>);

}  // namespace pbrt
