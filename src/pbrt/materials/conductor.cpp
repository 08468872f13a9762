#include "pbrt/materials/conductor.h"

namespace pbrt {

ConductorMaterial ConductorMaterial::Create(ParamDict &params, const NamedTextures &named) {
    ConductorMaterial m;
    const auto eta = FindSpectrumTexture(params, named, "eta", SpectrumType::Unbounded);
    const auto k = FindSpectrumTexture(params, named, "k", SpectrumType::Unbounded);
    m.reflectance = FindSpectrumTexture(params, named, "reflectance", SpectrumType::Albedo);
    if (m.reflectance && (eta || k))
        params.Error("reflectance", "give \"reflectance\" or \"eta\" and \"k\", not both");
    m.eta = eta.value_or(SpectrumTexture(*GetNamedSpectrum("metal-Cu-eta")));
    m.k = k.value_or(SpectrumTexture(*GetNamedSpectrum("metal-Cu-k")));
    m.roughness = Roughness::Create(params, named);
    return m;
}

}  // namespace pbrt
