#include "pbrt/render/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>

#include "pbrt/render/adaptive.h"

namespace pbrt {
namespace {

/// Small enough that two threads end together, big enough for batches of one sample per pixel.
constexpr int kTileSize = 16;

/// What the threads tell each other.
struct Shared {
    std::atomic<int64_t> done{0}, samples{0}, closest{0}, shadow{0};
    std::atomic<bool> stopped{false};
};

/// The threads' tracers, and the tiles they share out.
template <typename SamplerT>
class Tiles {
  public:
    using Tracer = BatchTracer<SamplerT>;

    Tiles(RenderScene &scene, const SamplerT &sampler, Shared &shared,
          const std::function<bool()> &keepGoing)
        : scene(scene), sampler(sampler), shared(shared), keepGoing(keepGoing), tracers([&] {
              return std::make_unique<Tracer>(scene, sampler);
          }) {}

    /// Calls render(pixels, tracer, ray counts) for each tile; it returns the samples a pixel got,
    /// which count as `planned` of those that show progress.
    template <typename F>
    void ForEach(int planned, const F &render) {
        const PixelBounds b = scene.film.Bounds();
        tbb::parallel_for(
            tbb::blocked_range2d<int>(b.y0, b.y1, kTileSize, b.x0, b.x1, kTileSize),
            [&](const tbb::blocked_range2d<int> &tile) {
                const std::vector<Point2i> pixels =
                    PixelsAlongCurve({tile.cols().begin(), tile.cols().end(), tile.rows().begin(),
                                      tile.rows().end()});
                RayCounts rays;
                const int spp = render(pixels, *tracers.local(), rays);
                shared.samples += spp * int64_t(pixels.size());
                shared.closest += rays.closest;
                shared.shadow += rays.shadow;
                shared.done += planned * int64_t(pixels.size());
                keepGoing();
            },
            tbb::simple_partitioner());
    }

    void Render() {
        const int spp = sampler.SamplesPerPixel();
        ForEach(spp, [&](std::span<const Point2i> pixels, Tracer &tracer, RayCounts &rays) {
            if (scene.targetError > 0)
                return RenderToError(scene, pixels, spp, scene.targetError, tracer, rays,
                                     keepGoing);
            RenderPixels(scene, pixels, spp, tracer, rays, keepGoing);
            return spp;
        });
    }

    void RenderInWaves(const std::function<void(int)> &afterWave) {
        const PixelBounds bounds = scene.film.Bounds();
        std::vector<Film::Pixel> sums(size_t(bounds.Area()), scene.film.NewPixel());
        const auto at = [&](Point2i p) -> Film::Pixel & {
            return sums[size_t(p.y - bounds.y0) * size_t(bounds.Width()) + size_t(p.x - bounds.x0)];
        };
        const int spp = sampler.SamplesPerPixel();
        for (int done = 0, end = 1; done < spp;
             done = end, end = int(std::min<int64_t>(2 * int64_t(end), spp))) {
            ForEach(end - done,
                    [&](std::span<const Point2i> pixels, Tracer &tracer, RayCounts &rays) {
                        std::vector<Film::Pixel> theirs;
                        for (const Point2i p : pixels)
                            theirs.push_back(at(p));
                        AddSamples(scene, pixels, done, end, theirs, tracer, rays, keepGoing);
                        for (size_t i = 0; i < pixels.size(); ++i)
                            at(pixels[i]) = theirs[i];
                        return end - done;
                    });
            if (shared.stopped) return;
            afterWave(end);
        }
    }

  private:
    RenderScene &scene;
    const SamplerT &sampler;
    Shared &shared;
    const std::function<bool()> &keepGoing;
    tbb::enumerable_thread_specific<std::unique_ptr<Tracer>> tracers;
};

}  // namespace

std::optional<RenderStats> Render(RenderScene &scene, int nThreads,
                                  const std::function<bool(int64_t, int64_t)> &progress,
                                  const std::function<void(int)> &afterWave) {
    const auto start = std::chrono::steady_clock::now();
    const int64_t planned =
        scene.film.Bounds().Area() *
        std::visit([](const auto &s) { return s.SamplesPerPixel(); }, scene.sampler);
    Shared shared;
    const std::function<bool()> keepGoing = [&] {
        if (!progress(shared.done, planned)) shared.stopped = true;
        return !shared.stopped;
    };
    tbb::task_arena arena(nThreads > 0 ? nThreads : tbb::task_arena::automatic);
    arena.execute([&] {
        std::visit(
            [&](const auto &sampler) {
                Tiles tiles(scene, sampler, shared, keepGoing);
                if (afterWave)
                    tiles.RenderInWaves(afterWave);
                else
                    tiles.Render();
            },
            scene.sampler);
    });
    if (shared.stopped) return {};
    RenderStats stats;
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    stats.cameraSamples = shared.samples;
    stats.rays = {shared.closest, shared.shadow};
    return stats;
}

}  // namespace pbrt
