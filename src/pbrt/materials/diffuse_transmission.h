#pragma once

#include "pbrt/bxdfs/diffuse_transmission.h"
#include "pbrt/materials/bounded_texture.h"

namespace pbrt {

/// Thin and matt, like paper or a leaf: `reflectance` and `transmittance` (albedo textures, default
/// 0.25 each), both times `scale`. More than 1 together makes light from nothing; pbrt-v4 allows
/// it.
struct DiffuseTransmissionMaterial {
    static constexpr std::string_view kName = "diffusetransmission";
    static constexpr bool kIsotropic = true;  ///< any frame about the normal will do
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
    std::string Warnings() const {
        std::string text;
        scale.AddRemark(kName, &text);
        return text;
    }
};

}  // namespace pbrt
