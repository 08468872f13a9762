#pragma once

#include "pbrt/base/sampler.h"
#include "pbrt/build/render_scene.h"

namespace pbrt {

/// The sampler's dimensions that a camera ray takes; an integrator's own begin at kEnd.
struct CameraDimensions {
    enum { kWavelength, kFilm, kTime, kLens, kEnd };
};
static_assert(CameraDimensions::kFilm == kFilmDimension);

/// A sample of the image: where and when its camera ray starts, and in which wavelengths.
struct CameraSample {
    Ray ray;
    SampledWavelengths lambda;
    float weight;  ///< of the pixel filter
};

/// Draws the dimensions [0, CameraDimensions::kEnd) of a sampler that stands at the pixel's sample.
template <typename SamplerT>
CameraSample DrawCameraSample(const RenderScene &scene, Point2i pixel, SamplerT *sampler) {
    const bool jitters = !scene.options.disablePixelJitter;
    const float uLambda = sampler->Get1D();
    const Point2f uFilm = sampler->Get2D();
    const float uTime = sampler->Get1D();
    const Point2f uLens = sampler->Get2D();
    const FilterSample f = jitters ? Sample(scene.filter, uFilm) : FilterSample{{}, 1};
    const Point2f film{pixel.x + 0.5f + f.p.x, pixel.y + 0.5f + f.p.y};
    const Ray ray = GenerateRay(scene.camera, film, jitters ? uLens : Point2f{0.5f, 0.5f},
                                             jitters ? uTime : 0.5f);
    return {ray,
            scene.film.SampleWavelengths(scene.options.disableWavelengthJitter ? 0.5f : uLambda),
            f.weight};
}

}  // namespace pbrt
