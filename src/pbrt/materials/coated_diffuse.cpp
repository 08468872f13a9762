#include "pbrt/materials/coated_diffuse.h"

#include "pbrt/materials/coat_params.h"

namespace pbrt {
namespace {

constexpr SpectrumParam kReflectance{"reflectance", SpectrumType::Albedo, "0.5",
                                     "albedo of the base"};
constexpr CoatEtaRows kEta{
    {"eta", "", 1.5f, 1, 1e3f, "index of refraction of the coat"},
    {"eta", SpectrumType::Unbounded, "", "the same, which must not vary with wavelength", 1, 1e3f}};

}  // namespace

CoatedDiffuseMaterial CoatedDiffuseMaterial::Create(ParamDict &params, const NamedTextures &named) {
    CoatedDiffuseMaterial m;
    m.reflectance = GetSpectrumTexture(params, named, kReflectance);
    m.roughness = Roughness::Create(params, named);
    const CoatParams coat = CoatParams::Get(params, named, kEta);
    m.coat = std::make_shared<const Coat>(coat.CoatWith(m.roughness));
    return m;
}

}  // namespace pbrt
