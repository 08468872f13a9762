#pragma once

#include <memory>

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/coated_conductor_bxdf.h"
#include "pbrt/materials/roughness.h"

namespace pbrt {

/// Metal (`conductor.eta` and `conductor.k`, default copper, or `reflectance`, not both) under a
/// dielectric coat: `interface.eta`, `thickness` (optical depth at normal incidence). Roughness of
/// either as in Roughness, with the prefixes `interface.` and `conductor.`. The coat only absorbs;
/// see CoatParams. As in pbrt-v4 eta and k are those against air, also where they follow from
/// `reflectance`: under the coat the metal then reflects less.
struct CoatedConductorMaterial {
    static constexpr std::string_view kName = "coatedconductor";
    static constexpr MaterialTraits kTraits{.canBeUniform = true, .laidByUV = true, .warns = true};
    static constexpr std::array<std::string_view, 5> kExamples{
        "", "\"float interface.roughness\" 0.1 \"float thickness\" 30",
        "\"float conductor.roughness\" 0.1 \"rgb reflectance\" [0.9 0.5 0.1]",
        "\"float interface.roughness\" 0.01 \"float conductor.uroughness\" 0.01 \"float "
        "conductor.vroughness\" 0.2 \"float thickness\" 0.3",
        "\"float interface.roughness\" 0.3 \"float interface.eta\" 1.3 "
        "\"spectrum conductor.eta\" \"metal-Au-eta\" \"spectrum conductor.k\" \"metal-Au-k\""};
    SpectrumTexture eta, k;
    std::optional<SpectrumTexture> reflectance;
    Roughness coatRoughness, baseRoughness;
    std::shared_ptr<const Coat> coat;
    std::shared_ptr<const CoatedBase> base;

    static CoatedConductorMaterial Create(ParamDict &params, const NamedTextures &named);
    bool IsUniform() const {
        return eta.IsConstant() && k.IsConstant() && coatRoughness.IsUniform() &&
               baseRoughness.IsUniform() && (!reflectance || reflectance->IsConstant());
    }
    CoatedConductorBxDF GetBxDF(const TextureEvalContext &ctx,
                                const SampledWavelengths &lambda) const;
    std::string_view LaidByUV() const {
        const std::string_view laid = coatRoughness.LaidByUV();
        return laid.empty() ? baseRoughness.LaidByUV() : laid;
    }
    std::string Warnings(const ClampCounts &counts) const;
};
static_assert(MaterialType<CoatedConductorMaterial>);

}  // namespace pbrt
