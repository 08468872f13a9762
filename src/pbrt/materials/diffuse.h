#pragma once

#include "pbrt/bxdfs/diffuse.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// Lambertian surface: `reflectance` (albedo texture, default 0.5).
struct DiffuseMaterial {
    static constexpr std::string_view kName = "diffuse";
    static constexpr bool kOneLobe = true;
    static constexpr bool kIsotropic = true;  ///< any frame about the normal will do
    static constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "0.5",
                                                "albedo"};
    SpectrumTexture reflectance{Spectrum(0.5f)};

    static DiffuseMaterial Create(ParamDict &params, const NamedTextures &named) {
        return {GetSpectrumTexture(params, named, kReflectance)};
    }
    bool IsUniform() const { return reflectance.IsConstant(); }
    DiffuseBxDF GetBxDF(const TextureEvalContext &ctx, SampledWavelengths &lambda) const {
        return DiffuseBxDF(reflectance.Evaluate(ctx, lambda));
    }
};

}  // namespace pbrt
