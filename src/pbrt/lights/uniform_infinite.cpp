#include "pbrt/lights/uniform_infinite.h"

#include "pbrt/lights/image_infinite.h"
#include "pbrt/lights/portal_infinite.h"

namespace pbrt {

std::optional<std::variant<UniformInfiniteLight, ImageInfiniteLight, PortalInfiniteLight>>
UniformInfiniteLight::Create(ParamDict &params, const Transform &renderFromLight,
                             const Transform &renderFromWorld) {
    if (!params.GetPoint3fArray(PortalInfiniteLight::kPortal).empty())
        return PortalInfiniteLight::Create(params, renderFromLight, renderFromWorld);
    if (!params.GetFileName(ImageInfiniteLight::kFileName).empty())
        return ImageInfiniteLight::Create(params, renderFromLight);
    const EmissionScale scale = GetScale(params, kLightIlluminance);
    const Emission emission = GetEmission(params, kLightRadiance);
    UniformInfiniteLight light;
    light.radiance = emission.spectrum;
    light.luminance = emission.luminance;
    // Illuminance of a patch under the hemisphere of radiance 1.
    light.scale = scale.For(Pi);
    return light;
}

}  // namespace pbrt
