#include "pbrt/lights/point.h"

namespace pbrt {

PointLight PointLight::Create(ParamDict &params, const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, "I");
    PointLight light;
    light.intensity = emission.spectrum;
    light.luminance = emission.luminance;
    light.scale = GetScale(params, "power", "lm").For(4 * Pi);
    light.p = renderFromLight.Point(params.GetOnePoint3f("from", {}));
    return light;
}

}  // namespace pbrt
