#pragma once

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/conductor_bxdf.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// Metal by its complex index (`eta`, `k`, default copper) or by its `reflectance` at normal
/// incidence, not both; roughness as in Roughness.
struct ConductorMaterial {
    static constexpr std::string_view kName = "conductor";
    static constexpr MaterialTraits kTraits{
        .oneLobe = true, .canBeUniform = true, .laidByUV = true, .warns = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"rgb reflectance\" [0.9 0.5 0.1] \"float roughness\" 0.3",
        "\"float uroughness\" 0.01 \"float vroughness\" 0.2"};
    SpectrumTexture eta, k;
    std::optional<SpectrumTexture> reflectance;
    Roughness roughness;

    static ConductorMaterial Create(ParamDict &params, const NamedTextures &named);
    bool IsUniform() const {
        return eta.IsConstant() && k.IsConstant() && roughness.IsUniform() &&
               (!reflectance || reflectance->IsConstant());
    }
    ConductorBxDF GetBxDF(const TextureEvalContext &ctx, const SampledWavelengths &lambda) const {
        const Vector2f alpha = roughness.Alpha(ctx);
        const ComplexIndex index =
            reflectance ? IndexOf(reflectance->Evaluate(ctx, lambda))
                        : ComplexIndex{eta.Evaluate(ctx, lambda), k.Evaluate(ctx, lambda)};
        return ConductorBxDF(index.eta, index.k, alpha.x, alpha.y);
    }
    std::string_view LaidByUV() const { return roughness.LaidByUV(); }
    std::string Warnings(const ClampCounts &counts) const {
        return roughness.Warnings(kName, counts);
    }
};
static_assert(MaterialType<ConductorMaterial>);

}  // namespace pbrt
