#pragma once

#include <optional>
#include <variant>

#include "pbrt/base/light.h"
#include "pbrt/lights/emission.h"
#include "pbrt/util/transform.h"

namespace pbrt {

struct ImageInfiniteLight;
struct PortalInfiniteLight;

/// The same radiance from every direction. Never light-sampled: following the BSDF finds it at
/// least as well.
struct UniformInfiniteLight {
    static constexpr std::string_view kName = "infinite";
    static constexpr LightTraits kTraits{
        .isInfinite = true, .neverSampled = true, .readsSceneRadius = true};
    static constexpr std::array<std::string_view, 2> kExamples{
        "", R"("float illuminance" 5 "blackbody L" 4000)"};
    /// A light through a portal where `portal` is given, else an image light where `filename` is.
    static std::optional<
        std::variant<UniformInfiniteLight, ImageInfiniteLight, PortalInfiniteLight>>
    Create(ParamDict &params, const Transform &renderFromLight, const Transform &renderFromWorld);

    void Preprocess(float radius) { sceneRadius = radius; }
    std::optional<LightLiSample> SampleLi(const LightSampleContext &, Point2f,
                                          const SampledWavelengths &) const {
        return std::nullopt;
    }
    float PDF_Li(Vector3f) const { return 0; }
    SampledSpectrum Le(Vector3f, const SampledWavelengths &lambda) const {
        return radiance->Sample(lambda) * scale;
    }
    float Power() const { return 4 * Sqr(Pi * sceneRadius) * scale * luminance; }
    std::optional<LightBounds> Bounds() const { return std::nullopt; }

    std::shared_ptr<const Spectrum> radiance;
    float scale = 1;
    float luminance = 0;
    float sceneRadius = 1;
};

}  // namespace pbrt
