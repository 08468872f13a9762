#include "pbrt/materials/dielectric.h"

namespace pbrt {
namespace {

constexpr FloatParam kEta{"eta", "", 1.5f, 1e-3f, 1e3f, "relative index of refraction"};

}  // namespace

DielectricMaterial DielectricMaterial::Create(ParamDict &params, const NamedTextures &named) {
    DielectricMaterial m;
    m.eta = params.Has("eta", "float")
                ? Spectrum(params.GetOneFloat(kEta))
                : params.GetOneSpectrum("eta", SpectrumType::Unbounded).value_or(Spectrum(1.5f));
    m.roughness = Roughness::Create(params, named);
    return m;
}

}  // namespace pbrt
