#pragma once

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/dielectric_bxdf.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// Glass-like interface: `eta` (float or spectrum, default 1.5); roughness as in Roughness. An eta
/// that varies with wavelength ends the secondary wavelengths of the path.
struct DielectricMaterial {
    static constexpr std::string_view kName = "dielectric";
    static constexpr MaterialTraits kTraits{
        .terminatesWavelengths = true, .canBeUniform = true, .laidByUV = true, .warns = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"float eta\" 1.33 \"float roughness\" 0.3", "\"spectrum eta\" \"glass-BK7\""};
    Spectrum eta{1.5f};
    Roughness roughness;

    /// The parameter `eta`; of thindielectric, too.
    static Spectrum GetEta(ParamDict &params);
    static DielectricMaterial Create(ParamDict &params, const NamedTextures &named);
    bool IsUniform() const { return roughness.IsUniform(); }
    DielectricBxDF GetBxDF(const TextureEvalContext &ctx, SampledWavelengths &lambda) const {
        if (!eta.IsConstant()) lambda.TerminateSecondary();
        const Vector2f alpha = roughness.Alpha(ctx);
        return DielectricBxDF(eta(lambda[0]), alpha.x, alpha.y);
    }
    std::string_view LaidByUV() const { return roughness.LaidByUV(); }
    std::string Warnings(const ClampCounts &counts) const {
        return roughness.Warnings(kName, counts);
    }
};
static_assert(MaterialType<DielectricMaterial>);

}  // namespace pbrt
