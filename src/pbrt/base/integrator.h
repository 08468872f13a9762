#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <string_view>

#include "pbrt/base/texture.h"
#include "pbrt/scene/params.h"
#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

struct RenderScene;
class IndependentSampler;

/// Rays traced, and values found out of range on the way; each thread counts its own.
struct RayCounts {
    int64_t closest = 0, shadow = 0;
    ClampCounts clamped;
    RayCounts &operator+=(const RayCounts &b) {
        closest += b.closest, shadow += b.shadow, clamped += b.clamped;
        return *this;
    }
};

class Tracer;

struct IntegratorTraits {
    /// Has a tracer of its own that takes many paths side by side; else Li is called path by path,
    /// which is some three times slower and a tenth of the text.
    bool tracesBatches = false;
    /// A scene without lights is worth a warning.
    bool usesLights = true;
};

/// An integrator estimates the light that arrives along camera rays. Its object holds its settings
/// and what it makes of the scene once; it is immutable while rendering and shared by all threads.
///   kName, kTraits
///   Create(params)       reads its settings; mistakes go to the dictionary's log
///   Preprocess(scene)    once, before rendering; the scene outlives the integrator's use
/// Without tracesBatches:
///   template <SamplerType S>
///   SampledSpectrum Li(const RenderScene &, Ray, SampledWavelengths *, S *, RayCounts *) const
///       An unbiased estimate of the radiance that arrives against ray.d (unit), in W / (m^2 sr nm)
///       up to the scene's own scale, at the given wavelengths. May terminate wavelengths (their
///       pdf becomes 0, the others' share is scaled) and draws any number of sample dimensions;
///       adds the rays it traces. The same arguments give the same bits.
/// With tracesBatches:
///   std::unique_ptr<Tracer> MakeTracer(const RenderScene &) const     see integrators/tracer.h
template <typename I>
concept IntegratorType = requires(I integrator, ParamDict &params, const RenderScene &scene) {
    { I::kName } -> std::convertible_to<std::string_view>;
    { I::kTraits } -> std::convertible_to<IntegratorTraits>;
    { I::Create(params) } -> std::same_as<I>;
    integrator.Preprocess(scene);
}
&& (I::kTraits.tracesBatches
          ? requires(const I &i, const RenderScene &scene) {
                { i.MakeTracer(scene) } -> std::same_as<std::unique_ptr<Tracer>>;
            }
          : requires(const I &i, const RenderScene &scene, Ray ray, SampledWavelengths *lambda,
                     IndependentSampler *sampler, RayCounts *counts) {
                { i.Li(scene, ray, lambda, sampler, counts) } -> std::same_as<SampledSpectrum>;
            });

}  // namespace pbrt
