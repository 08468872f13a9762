#pragma once

#include <array>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/diffuse_transmission_bxdf.h"
#include "pbrt/materials/bounded_texture.h"

namespace pbrt {

/// Thin and diffuse, like paper or a leaf: `reflectance` and `transmittance` (albedo textures,
/// default 0.25 each), both times `scale`. More than 1 together makes light from nothing; pbrt-v4
/// allows it.
struct DiffuseTransmissionMaterial {
    static constexpr std::string_view kName = "diffusetransmission";
    static constexpr MaterialTraits kTraits{.isotropic = true, .warns = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        "", "\"rgb reflectance\" [0.1 0.5 0.9] \"rgb transmittance\" [0 0 0] \"float scale\" 0.5"};
    SpectrumTexture reflectance, transmittance;
    BoundedTexture scale;

    static DiffuseTransmissionMaterial Create(ParamDict &params, const NamedTextures &named);
    DiffuseTransmissionBxDF GetBxDF(const TextureEvalContext &ctx,
                                    const SampledWavelengths &lambda) const {
        const float s = scale.Evaluate(ctx);
        return DiffuseTransmissionBxDF(ClampToUnit(s * reflectance.Evaluate(ctx, lambda)),
                                       ClampToUnit(s * transmittance.Evaluate(ctx, lambda)));
    }
    /// A sentence where texture values had to be clamped; else empty.
    std::string Warnings(const ClampCounts &counts) const {
        std::string text;
        scale.AddWarning(kName, counts, &text);
        return text;
    }
};
static_assert(MaterialType<DiffuseTransmissionMaterial>);

}  // namespace pbrt
