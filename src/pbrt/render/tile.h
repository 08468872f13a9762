#pragma once

#include <functional>
#include <vector>

#include "pbrt/integrators/path/batch_tracer.h"

namespace pbrt {

/// Pixels of [x0, x1) x [y0, y1) in the order of a Z-curve: neighbours share batches.
std::vector<Point2i> PixelsAlongCurve(const PixelBounds &tile);

/// Samples [begin, end) of each pixel, in batches, added to `sums`; less where keepGoing(), asked
/// before each batch, says no.
template <typename Tracer>
void AddSamples(RenderScene &scene, std::span<const Point2i> pixels, int begin, int end,
                std::span<Film::Pixel> sums, Tracer &tracer, RayCounts &rays,
                const std::function<bool()> &keepGoing) {
    const size_t together = size_t(std::max(1, kBatchSize / (end - begin)));
    for (size_t first = 0; first < pixels.size(); first += together) {
        const size_t n = std::min(together, pixels.size() - first);
        const auto some = pixels.subspan(first, n);
        const auto theirs = sums.subspan(first, n);
        for (int done = begin; done < end; done += kBatchSize) {
            if (!keepGoing()) return;
            tracer.Trace({some, done, std::min(end, done + kBatchSize)}, theirs, rays);
        }
        for (size_t i = 0; i < n; ++i)
            scene.film.Store(some[i], theirs[i]);
    }
}

/// All samples of the pixels.
template <typename Tracer>
void RenderPixels(RenderScene &scene, std::span<const Point2i> pixels, int samplesPerPixel,
                  Tracer &tracer, RayCounts &rays, const std::function<bool()> &keepGoing) {
    std::vector<Film::Pixel> sums(pixels.size(), scene.film.NewPixel());
    AddSamples(scene, pixels, 0, samplesPerPixel, sums, tracer, rays, keepGoing);
}

}  // namespace pbrt
