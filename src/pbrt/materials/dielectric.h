#pragma once

#include "pbrt/bxdfs/dielectric.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// Glass-like interface: `eta` (float or spectrum, default 1.5); roughness as in Roughness. An eta
/// that varies with wavelength ends the secondary wavelengths of the path.
struct DielectricMaterial {
    static constexpr std::string_view kName = "dielectric";
    Spectrum eta{1.5f};
    Roughness roughness;

    static DielectricMaterial Create(ParamDict &params, const NamedTextures &named);
    bool IsUniform() const { return roughness.IsUniform(); }
    DielectricBxDF GetBxDF(const TextureEvalContext &ctx, SampledWavelengths &lambda) const {
        if (!eta.IsConstant()) lambda.TerminateSecondary();
        const Vector2f alpha = roughness.Alpha(ctx);
        return DielectricBxDF(eta(lambda[0]), alpha.x, alpha.y);
    }
    std::string Warnings() const { return roughness.Warnings(kName); }
};

}  // namespace pbrt
