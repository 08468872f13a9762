#include "pbrt/materials/conductor.h"

namespace pbrt {
namespace {

constexpr SpectrumParam kEta{"eta", SpectrumType::Unbounded, "metal-Cu-eta", "index of refraction"};
constexpr SpectrumParam kK{"k", SpectrumType::Unbounded, "metal-Cu-k", "absorption coefficient"};
constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "",
                                     "at normal incidence, instead of eta and k"};

}  // namespace

ConductorMaterial ConductorMaterial::Create(ParamDict &params, const NamedTextures &named) {
    ConductorMaterial m;
    const auto eta = FindSpectrumTexture(params, named, kEta);
    const auto k = FindSpectrumTexture(params, named, kK);
    m.reflectance = FindSpectrumTexture(params, named, kReflectance);
    if (m.reflectance && (eta || k))
        params.Error(kReflectance.name, "give \"reflectance\" or \"eta\" and \"k\", not both");
    m.eta = eta.value_or(DefaultSpectrum(kEta));
    m.k = k.value_or(DefaultSpectrum(kK));
    m.roughness = Roughness::Create(params, named);
    return m;
}

}  // namespace pbrt
