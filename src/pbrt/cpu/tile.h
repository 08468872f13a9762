#pragma once

#include <functional>
#include <vector>

#include "pbrt/cpu/batch_tracer.h"

namespace pbrt {

/// Pixels of [x0, x1) x [y0, y1) in the order of a Z-curve: neighbours share batches.
std::vector<Point2i> PixelsAlongCurve(const PixelBounds &tile);

/// All samples of the pixels, in batches; less where keepGoing(), asked before each batch, says no.
template <typename Tracer>
void RenderPixels(World &world, std::span<const Point2i> pixels, int samplesPerPixel,
                  Tracer &tracer, RayCounts &rays, const std::function<bool()> &keepGoing) {
    const size_t together = size_t(std::max(1, kBatchSize / samplesPerPixel));
    for (size_t first = 0; first < pixels.size(); first += together) {
        const auto some = pixels.subspan(first, std::min(together, pixels.size() - first));
        std::vector<Film::Pixel> sums(some.size(), world.film.NewPixel());
        for (int done = 0; done < samplesPerPixel; done += kBatchSize) {
            if (!keepGoing()) return;
            const int last = std::min(samplesPerPixel, done + kBatchSize);
            tracer.Trace({some, done, last}, sums, rays);
        }
        for (size_t i = 0; i < some.size(); ++i)
            world.film.Store(some[i], sums[i]);
    }
}

}  // namespace pbrt
