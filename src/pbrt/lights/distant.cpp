#include "pbrt/lights/distant.h"

#include "pbrt/lights/from_to.h"

namespace pbrt {
namespace {

constexpr SpectrumParam kIrradiance{"L", SpectrumType::Illuminant, "the color space's white",
                                    "spectrum of the irradiance on a surface that faces the light"};

}  // namespace

DistantLight DistantLight::Create(ParamDict &params, const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, kIrradiance);
    const Vector3f along = GetFromTo(params, renderFromLight).along;
    DistantLight light;
    light.irradiance = emission.spectrum;
    light.luminance = emission.luminance;
    light.scale = GetScale(params, kLightIlluminance).For(1);
    light.toLight = Normalize(renderFromLight.Vector(-along));
    return light;
}

}  // namespace pbrt
