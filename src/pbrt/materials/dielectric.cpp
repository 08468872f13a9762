#include "pbrt/materials/dielectric.h"

namespace pbrt {
namespace {

constexpr FloatParam kEta{"eta", "", 1.5f, 1e-3f, 1e3f, "relative index of refraction"};
constexpr SpectrumParam kEtaSpectrum{"eta", SpectrumType::Unbounded, "", "the same, by wavelength"};

}  // namespace

Spectrum DielectricMaterial::GetEta(ParamDict &params) {
    if (params.Has(kEta)) return Spectrum(params.GetOneFloat(kEta));
    return params.GetOneSpectrum(kEtaSpectrum).value_or(Spectrum(kEta.def));
}

DielectricMaterial DielectricMaterial::Create(ParamDict &params, const NamedTextures &named) {
    return {GetEta(params), Roughness::Create(params, named)};
}

}  // namespace pbrt
