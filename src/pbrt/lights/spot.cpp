#include "pbrt/lights/spot.h"

#include "pbrt/lights/from_to.h"

namespace pbrt {
namespace {

constexpr FloatParam kConeAngle{"coneangle", "degrees", 30, 0, 180, "half angle of the cone"};
constexpr FloatParam kConeDelta{
    "conedeltaangle", "degrees", 5, 0, 180, "width of the falloff inside the cone"};

/// Solid angle of the cone, weighted by the falloff: a smooth step has the mean 1/2.
float EffectiveSolidAngle(float cosStart, float cosEnd) {
    return 2 * Pi * (1 - (cosStart + cosEnd) / 2);
}

}  // namespace

SpotLight SpotLight::Create(ParamDict &params, const Transform &renderFromLight) {
    const Emission emission = GetEmission(params, kLightIntensity);
    const auto [from, along] = GetFromTo(params, renderFromLight);
    const float cone = params.GetOneFloat(kConeAngle), delta = params.GetOneFloat(kConeDelta);
    // A delta beyond the cone counts from the other side, as in pbrt-v4.
    const float start = std::min(std::abs(cone - delta), cone);
    const float cosStart = std::cos(Radians(start)), cosEnd = std::cos(Radians(cone));
    SpotLight light;
    light.beam =
        std::make_shared<Beam>(Beam{emission.spectrum, emission.luminance,
                                    renderFromLight.Inverse(), Normalize(along), cosStart, cosEnd});
    light.p = renderFromLight.Point(from);
    light.scale = GetScale(params, kLightPower).For(EffectiveSolidAngle(cosStart, cosEnd));
    return light;
}

float SpotLight::Power() const {
    return EffectiveSolidAngle(beam->cosStart, beam->cosEnd) * scale * beam->luminance;
}

std::optional<LightBounds> SpotLight::Bounds() const {
    const Vector3f axis = Normalize(beam->lightFromRender.Inverse().Vector(beam->axis));
    // The flux of a point light as bright as the beam: that is what its inside receives.
    const float power = 4 * Pi * scale * beam->luminance;
    const float cosFalloff = std::cos(std::acos(beam->cosEnd) - std::acos(beam->cosStart));
    return LightBounds{{p, p}, {axis, beam->cosStart}, cosFalloff, power, false};
}

}  // namespace pbrt
