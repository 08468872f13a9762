#include "pbrt/cpu/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>

#include "pbrt/cpu/adaptive.h"

namespace pbrt {
namespace {

/// Small enough that two threads end together, big enough for batches of one sample per pixel.
constexpr int kTileSize = 16;

/// What the threads tell each other.
struct Shared {
    std::atomic<int64_t> pixelsDone{0}, samples{0}, closest{0}, shadow{0};
    std::atomic<bool> stopped{false};
};

template <typename SamplerT>
void RenderTiles(World &world, const SamplerT &sampler, Shared &shared,
                 const std::function<bool()> &keepGoing) {
    using Tracer = BatchTracer<SamplerT>;
    tbb::enumerable_thread_specific<std::unique_ptr<Tracer>> tracers(
        [&] { return std::make_unique<Tracer>(world, sampler); });
    const PixelBounds b = world.film.Bounds();
    tbb::parallel_for(
        tbb::blocked_range2d<int>(b.y0, b.y1, kTileSize, b.x0, b.x1, kTileSize),
        [&](const tbb::blocked_range2d<int> &tile) {
            const std::vector<Point2i> pixels = PixelsAlongCurve(
                {tile.cols().begin(), tile.cols().end(), tile.rows().begin(), tile.rows().end()});
            RayCounts rays;
            int spp = sampler.SamplesPerPixel();
            if (world.targetError > 0)
                spp = RenderToError(world, pixels, spp, world.targetError, *tracers.local(), rays,
                                    keepGoing);
            else
                RenderPixels(world, pixels, spp, *tracers.local(), rays, keepGoing);
            shared.samples += spp * int64_t(pixels.size());
            shared.closest += rays.closest;
            shared.shadow += rays.shadow;
            shared.pixelsDone += int64_t(pixels.size());
            keepGoing();
        },
        tbb::simple_partitioner());
}

}  // namespace

std::optional<RenderStats> Render(World &world, int nThreads,
                                  const std::function<bool(int64_t, int64_t)> &progress) {
    const auto start = std::chrono::steady_clock::now();
    const int64_t nPixels = world.film.Bounds().Area();
    Shared shared;
    const std::function<bool()> keepGoing = [&] {
        if (!progress(shared.pixelsDone, nPixels)) shared.stopped = true;
        return !shared.stopped;
    };
    tbb::task_arena arena(nThreads > 0 ? nThreads : tbb::task_arena::automatic);
    arena.execute([&] {
        std::visit([&](const auto &s) { RenderTiles(world, s, shared, keepGoing); }, world.sampler);
    });
    if (shared.stopped) return {};
    RenderStats stats;
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    stats.cameraSamples = shared.samples;
    stats.rays = {shared.closest, shared.shadow};
    return stats;
}

}  // namespace pbrt
