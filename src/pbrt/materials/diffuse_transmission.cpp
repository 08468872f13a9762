#include "pbrt/materials/diffuse_transmission.h"

namespace pbrt {
namespace {

constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "0.25",
                                     "albedo of the side that light comes from"};
constexpr SpectrumParam kTransmittance{"transmittance", SpectrumType::Albedo, "0.25",
                                       "share of light scattered to the other side"};
constexpr FloatParam kScale{"scale", "", 1, 0, 1e6f, "factor of both"};

}  // namespace

DiffuseTransmissionMaterial DiffuseTransmissionMaterial::Create(ParamDict &params,
                                                                const NamedTextures &named) {
    DiffuseTransmissionMaterial m;
    m.reflectance = GetSpectrumTexture(params, named, kReflectance);
    m.transmittance = GetSpectrumTexture(params, named, kTransmittance);
    m.scale = {params, named, kScale};
    return m;
}

}  // namespace pbrt
