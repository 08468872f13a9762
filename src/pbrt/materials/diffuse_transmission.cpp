#include "pbrt/materials/diffuse_transmission.h"

namespace pbrt {
namespace {

constexpr FloatParam kScale{"scale", "", 1, 0, 1e6f, "factor of both"};

}  // namespace

DiffuseTransmissionMaterial DiffuseTransmissionMaterial::Create(ParamDict &params,
                                                                const NamedTextures &named) {
    const auto albedo = [&](std::string_view name) {
        return GetSpectrumTexture(params, named, name, Spectrum(0.25f), SpectrumType::Albedo);
    };
    DiffuseTransmissionMaterial m;
    m.reflectance = albedo("reflectance");
    m.transmittance = albedo("transmittance");
    m.scale = {params, named, kScale};
    return m;
}

}  // namespace pbrt
