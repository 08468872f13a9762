#pragma once

#include <memory>

#include "pbrt/bxdfs/coated_diffuse.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// A matt base (`reflectance`, default 0.5) under a dielectric coat: `eta` (a number, or a spectrum
/// that is the same everywhere, >= 1), `thickness` (its optical depth at normal incidence; a
/// number), roughness as in Roughness. The coat only absorbs: `albedo` must be 0. `g`, `maxdepth`
/// and `nsamples` are read and have no effect, for nothing is left to chance.
struct CoatedDiffuseMaterial {
    static constexpr std::string_view kName = "coateddiffuse";
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
    std::string Warnings() const { return roughness.Warnings(kName); }
};

}  // namespace pbrt
