#include "pbrt/lights/distant.h"

#include "pbrt/lights/from_to.h"

namespace pbrt {

DistantLight DistantLight::Create(ParamDict &params, const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, "L");
    const Vector3f along = GetFromTo(params, renderFromLight).along;
    DistantLight light;
    light.irradiance = emission.spectrum;
    light.luminance = emission.luminance;
    light.scale = GetScale(params, "illuminance", "lx").For(1);
    light.toLight = Normalize(renderFromLight.Vector(-along));
    return light;
}

}  // namespace pbrt
