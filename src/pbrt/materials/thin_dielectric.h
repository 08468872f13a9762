#pragma once

#include "pbrt/base/material.h"
#include "pbrt/bxdfs/thin_dielectric_bxdf.h"
#include "pbrt/materials/dielectric.h"

namespace pbrt {

/// A pane of glass that is modelled as one surface: `eta` (float or spectrum, default 1.5). An eta
/// that varies with wavelength ends the secondary wavelengths of the path.
struct ThinDielectricMaterial {
    static constexpr std::string_view kName = "thindielectric";
    static constexpr MaterialTraits kTraits{
        .terminatesWavelengths = true, .isotropic = true, .canBeUniform = true};
    static constexpr std::array<std::string_view, 3> kExamples{"", "\"float eta\" 2.5",
                                                               "\"spectrum eta\" \"glass-BK7\""};
    Spectrum eta{1.5f};

    static ThinDielectricMaterial Create(ParamDict &params, const NamedTextures &) {
        return {DielectricMaterial::GetEta(params)};
    }
    static bool IsUniform() { return true; }
    ThinDielectricBxDF GetBxDF(const TextureEvalContext &, SampledWavelengths &lambda) const {
        if (!eta.IsConstant()) lambda.TerminateSecondary();
        return ThinDielectricBxDF(eta(lambda[0]));
    }
};
static_assert(MaterialType<ThinDielectricMaterial>);

}  // namespace pbrt
