#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "pbrt/shapes/shape.h"
#include "pbrt/spectra/color.h"
#include "pbrt/spectra/spectrum.h"

namespace pbrt {

/// Where light arrives. n, ns = 0 where the receiver takes light from all sides.
struct LightSampleContext {
    Point3f p;
    Normal3f n, ns;
};

/// Light from one sampled direction.
struct LightLiSample {
    SampledSpectrum L;
    Vector3f wi;
    float pdf;         ///< per unit solid angle; 1 for delta lights
    Point3f pLight;    ///< end of the shadow ray (already moved off the light's surface)
    bool delta;        ///< point, spot, distant: no BSDF sample can find it
};

// Each light type is a struct in its own file with these members:
//   static constexpr std::string_view kName
//   std::optional<LightLiSample> SampleLi(const LightSampleContext &, Point2f u,
//                                         const SampledWavelengths &) const
//   float PDF_Li(const LightSampleContext &, Vector3f wi) const         (infinite lights)
//   SampledSpectrum Le(const Ray &, const SampledWavelengths &) const   (infinite lights)
//   float Power() const     W-like, luminance-weighted, for choosing lights
struct PointLight;
struct SpotLight;
struct DistantLight;
struct UniformInfiniteLight;
struct ImageInfiniteLight;
struct DiffuseAreaLight;

}  // namespace pbrt
