#include "pbrt/lights/point.h"

#include "pbrt/lights/from_to.h"

namespace pbrt {

PointLight PointLight::Create(ParamDict &params, const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, kLightIntensity);
    PointLight light;
    light.intensity = emission.spectrum;
    light.luminance = emission.luminance;
    light.scale = GetScale(params, kLightPower).For(4 * Pi);
    light.p = renderFromLight.Point(params.GetOnePoint3f(kLightFrom));
    return light;
}

}  // namespace pbrt
