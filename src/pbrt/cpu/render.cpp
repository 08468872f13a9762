#include "pbrt/cpu/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>

#include "pbrt/cpu/first_seen.h"

namespace pbrt {
namespace {

/// Small enough that two threads end together, big enough that neighbours share cache.
constexpr int kTileSize = 16;

/// So many samples of one pixel are taken between two looks at whether to stop.
constexpr int kSamplesBetweenPolls = 4096;

/// One pixel with all its samples; less where keepGoing() says no.
template <typename SamplerT, typename F>
Film::Pixel RenderPixel(const World &world, Point2i p, SamplerT &sampler, RayCounts &rays,
                        const F &keepGoing) {
    Film::Pixel pixel = world.film.NewPixel();
    PathTracer<SamplerT> tracer(world, sampler, rays);
    const int spp = sampler.SamplesPerPixel();
    for (int index = 0; index < spp; ++index) {
        if (index % kSamplesBetweenPolls == kSamplesBetweenPolls - 1 && !keepGoing()) break;
        sampler.StartPixelSample(p, index);
        const float uLambda = sampler.Get1D();
        SampledWavelengths lambda =
            world.film.SampleWavelengths(world.options.disableWavelengthJitter ? 0.5f : uLambda);
        FilterSample fs = Sample(world.filter, sampler.GetPixel2D());
        float time = world.moves ? sampler.Get1D() : 0;
        Point2f lens = world.camera.HasLens() ? sampler.Get2D() : Point2f{0.5f, 0.5f};
        if (world.options.disablePixelJitter) {
            fs = {{0, 0}, 1};
            time = 0.5f, lens = {0.5f, 0.5f};
        }
        const Point2f film{p.x + 0.5f + fs.p.x, p.y + 0.5f + fs.p.y};
        const Ray ray = world.camera.GenerateRay(film, lens, time);
        std::optional<VisibleSurface> seen;
        if (world.film.WantsSurface()) [[unlikely]]
            seen = FirstSeen(world, ray, lambda);
        SampledSpectrum L = tracer.Li(ray, lambda);
        // Never seen in tests; a picture must not lose a pixel to one path.
        if (!L.IsFinite()) L = SampledSpectrum(0);
        world.film.AddSample(&pixel, L, lambda, fs.weight, seen ? &*seen : nullptr);
    }
    return pixel;
}

}  // namespace

std::optional<RenderStats> Render(World &world, int nThreads,
                                  const std::function<bool(int64_t, int64_t)> &progress) {
    const auto start = std::chrono::steady_clock::now();
    const PixelBounds b = world.film.Bounds();
    std::atomic<int64_t> pixelsDone{0}, closest{0}, shadow{0};
    std::atomic<bool> stopped{false};
    const auto keepGoing = [&] {
        if (!progress(pixelsDone, b.Area())) stopped = true;
        return !stopped;
    };
    const auto renderTile = [&](const tbb::blocked_range2d<int> &tile) {
        RayCounts rays;
        std::visit(
            [&](auto sampler) {
                for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
                    for (int x = tile.cols().begin(); x < tile.cols().end() && !stopped; ++x)
                        world.film.Store({x, y},
                                         RenderPixel(world, {x, y}, sampler, rays, keepGoing));
            },
            world.sampler);
        closest += rays.closest;
        shadow += rays.shadow;
        pixelsDone += int64_t(tile.rows().size()) * int64_t(tile.cols().size());
        keepGoing();
    };
    tbb::task_arena arena(nThreads > 0 ? nThreads : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range2d<int>(b.y0, b.y1, kTileSize, b.x0, b.x1, kTileSize),
                          renderTile, tbb::simple_partitioner());
    });
    if (stopped) return {};
    const int spp = std::visit([](const auto &s) { return s.SamplesPerPixel(); }, world.sampler);
    RenderStats stats;
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    stats.cameraSamples = b.Area() * spp;
    stats.rays = {closest, shadow};
    return stats;
}

}  // namespace pbrt
