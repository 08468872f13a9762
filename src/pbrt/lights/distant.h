#pragma once

#include "pbrt/base/light.h"
#include "pbrt/lights/emission.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// Parallel light; L is the irradiance on a surface across it.
struct DistantLight {
    static constexpr std::string_view kName = "distant";
    static constexpr LightTraits kTraits{.isDelta = true, .readsSceneRadius = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        "", R"("point3 from" [ 0 1 8 ] "float illuminance" 12)"};
    static DistantLight Create(ParamDict &params, const Transform &renderFromLight);

    void Preprocess(float radius) { sceneRadius = radius; }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &ctx, Point2f,
                                          const SampledWavelengths &lambda) const {
        if (scale == 0) return std::nullopt;
        return LightLiSample{irradiance->Sample(lambda) * scale, toLight, 1,
                             ctx.p + (2 * sceneRadius) * toLight, true};
    }
    float Power() const { return Pi * Sqr(sceneRadius) * scale * luminance; }
    std::optional<LightBounds> Bounds() const { return std::nullopt; }

    std::shared_ptr<const Spectrum> irradiance;
    Vector3f toLight;  ///< unit
    float scale = 1;
    float luminance = 0;
    float sceneRadius = 1;
};

}  // namespace pbrt
