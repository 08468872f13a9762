#include "pbrt/lights/distant.h"

namespace pbrt {

DistantLight DistantLight::Create(ParamDict &params, const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, "L");
    const Point3f from = params.GetOnePoint3f("from", {});
    const Point3f to = params.GetOnePoint3f("to", {0, 0, 1});
    if (from == to) params.Error("to", "\"from\" and \"to\" are the same point: no direction");
    DistantLight light;
    light.irradiance = emission.spectrum;
    light.luminance = emission.luminance;
    light.scale = GetScale(params, "illuminance", "lx").For(1);
    const Vector3f back = from == to ? Vector3f{0, 0, -1} : from - to;
    light.toLight = Normalize(renderFromLight.Vector(back));
    return light;
}

}  // namespace pbrt
