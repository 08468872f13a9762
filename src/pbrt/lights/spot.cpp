#include "pbrt/lights/spot.h"

#include "pbrt/lights/from_to.h"

namespace pbrt {
namespace {

constexpr FloatParam kConeAngle{"coneangle", "deg", 30, 0, 180, "half angle of the cone"};
constexpr FloatParam kConeDelta{
    "conedeltaangle", "deg", 5, 0, 180, "width of the falloff inside the cone"};

/// Whether a transform only turns, mirrors, moves and scales evenly, to within 1e-4.
bool KeepsAngles(const Transform &t) {
    const std::array<Vector3f, 3> axes{t.Vector({1, 0, 0}), t.Vector({0, 1, 0}),
                                       t.Vector({0, 0, 1})};
    const float size = LengthSquared(axes[0]), least = 1e-4f * size;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j)
            if (std::abs(Dot(axes[i], axes[j]) - (i == j ? size : 0)) > least) return false;
    return true;
}

/// Solid angle of a round cone, weighted by the falloff: a smooth step has the mean 1/2.
float RoundSolidAngle(float cosStart, float cosEnd) {
    return 2 * Pi * (1 - (cosStart + cosEnd) / 2);
}

/// Solid angle of the light's cone in rendering space; where a transform stretches it, a sum over
/// 4096 even directions: some ten percent off where it is ten degrees wide, less for wider ones.
float SolidAngle(const SpotLight &light) {
    const SpotLight::Beam &beam = *light.beam;
    if (beam.keepsAngles) return RoundSolidAngle(beam.cosStart, beam.cosEnd);
    constexpr int kDirections = 4096;
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) {
        // A spiral whose turns lie a golden section of a turn apart.
        const float z = 1 - (2 * float(i) + 1) / kDirections, phi = float(i) * 2.39996323f;
        const float r = std::sqrt(std::max(0.f, 1 - z * z));
        sum += light.Falloff(light.CosTheta({r * std::cos(phi), r * std::sin(phi), z}));
    }
    return float(sum / kDirections) * 4 * Pi;
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
    Beam beam{emission.spectrum,
              emission.luminance,
              renderFromLight.Inverse(),
              Normalize(along),
              cosStart,
              cosEnd,
              0,
              KeepsAngles(renderFromLight)};
    light.beam = std::make_shared<Beam>(beam);
    beam.solidAngle = SolidAngle(light);
    light.beam = std::make_shared<Beam>(beam);
    light.p = renderFromLight.Point(from);
    light.scale = GetScale(params, kLightPower).For(RoundSolidAngle(cosStart, cosEnd));
    return light;
}

float SpotLight::Power() const {
    return beam->solidAngle * scale * beam->luminance;
}

std::optional<LightBounds> SpotLight::Bounds() const {
    const Vector3f axis = Normalize(beam->lightFromRender.Inverse().Vector(beam->axis));
    // The flux of a point light as bright as the beam: that is what its inside receives.
    const float power = 4 * Pi * scale * beam->luminance;
    // A stretched cone may be as wide as it likes.
    if (!beam->keepsAngles) return LightBounds{{p, p}, {axis, -1}, 1, power, false};
    const float cosFalloff = std::cos(std::acos(beam->cosEnd) - std::acos(beam->cosStart));
    return LightBounds{{p, p}, {axis, beam->cosStart}, cosFalloff, power, false};
}

}  // namespace pbrt
