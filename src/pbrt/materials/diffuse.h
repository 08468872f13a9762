#pragma once

#include <array>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/diffuse_bxdf.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// Lambertian surface: `reflectance` (albedo texture, default 0.5).
struct DiffuseMaterial {
    static constexpr std::string_view kName = "diffuse";
    static constexpr MaterialTraits kTraits{
        .oneLobe = true, .isotropic = true, .canBeUniform = true};
    static constexpr std::array<std::string_view, 2> kExamples{"",
                                                               "\"rgb reflectance\" [0.1 0.5 0.9]"};
    static constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "0.5",
                                                "albedo"};
    SpectrumTexture reflectance{Spectrum(0.5f)};

    static DiffuseMaterial Create(ParamDict &params, const NamedTextures &named) {
        return {GetSpectrumTexture(params, named, kReflectance)};
    }
    bool IsUniform() const { return reflectance.IsConstant(); }
    DiffuseBxDF GetBxDF(const TextureEvalContext &ctx, const SampledWavelengths &lambda) const {
        return DiffuseBxDF(ClampToUnit(reflectance.Evaluate(ctx, lambda)));
    }
};
static_assert(MaterialType<DiffuseMaterial>);

}  // namespace pbrt
