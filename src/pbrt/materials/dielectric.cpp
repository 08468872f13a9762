#include "pbrt/materials/dielectric.h"

namespace pbrt {
namespace {

constexpr FloatParam kEta{"eta", "", 1.5f, 1e-3f, 1e3f, "relative index of refraction"};
constexpr SpectrumParam kEtaSpectrum{"eta", SpectrumType::Unbounded, "", "the same, by wavelength"};

}  // namespace

DielectricMaterial DielectricMaterial::Create(ParamDict &params, const NamedTextures &named) {
    DielectricMaterial m;
    m.eta = params.Has(kEta) ? Spectrum(params.GetOneFloat(kEta))
                             : params.GetOneSpectrum(kEtaSpectrum).value_or(Spectrum(kEta.def));
    m.roughness = Roughness::Create(params, named);
    return m;
}

}  // namespace pbrt
