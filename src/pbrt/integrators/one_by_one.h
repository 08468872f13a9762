#pragma once

#include <vector>

#include "pbrt/build/surface_bsdf.h"  // defines VisitBSDF
#include "pbrt/build/visible_surface.h"
#include "pbrt/integrators/camera_sample.h"
#include "pbrt/integrators/tracer.h"

namespace pbrt {

/// Traces the samples of an integrator that has Li, path by path.
template <typename I, typename SamplerT>
class OneByOneTracer final : public Tracer {
  public:
    OneByOneTracer(const RenderScene &scene, const I &integrator, const SamplerT &sampler)
        : scene(scene), integrator(integrator), sampler(sampler) {}

    void StartTile(std::span<const Point2i> tile) override {
        pixels.assign(tile.begin(), tile.end());
    }

    void Trace(const SampleBatch &batch, std::span<Film::Pixel> sums, RayCounts &counts) override {
        for (int p = batch.firstPixel; p < batch.lastPixel; ++p) {
            Film::Samples samples(scene.film, &sums[size_t(p)]);
            for (int k = batch.firstSample; k < batch.lastSample; ++k) {
                sampler.StartPixelSample(pixels[size_t(p)], k);
                AddSample(pixels[size_t(p)], &samples, counts);
            }
            samples.Finish();
        }
    }

  private:
    void AddSample(Point2i pixel, Film::Samples *samples, RayCounts &counts) {
        CameraSample c = DrawCameraSample(scene, pixel, &sampler);
        std::optional<VisibleSurface> seen;
        if (scene.film.WantsSurface()) seen = FindVisibleSurface(scene, c.ray, c.lambda);
        SampledSpectrum L = integrator.Li(scene, c.ray, &c.lambda, &sampler, &counts);
        // Never seen in tests; an image must not lose a pixel to one path.
        if (!L.IsFinite()) L = SampledSpectrum(0);
        samples->Add(L, c.lambda, c.weight, seen ? &*seen : nullptr);
    }

    const RenderScene &scene;
    const I &integrator;
    SamplerT sampler;
    std::vector<Point2i> pixels;
};

}  // namespace pbrt
