// Error of a picture against the processor time spent on it, one thread, when feathers are sampled
// by their model, by a cosine lobe (both with light sampling, power heuristic), and with light
// sampling only. Writes CSV: way, samples per pixel, seconds, root-mean-square error of linear RGB
// over the picture, relative to the reference's mean.
//   bench_sampling scene.pbrt [reference's samples per pixel, default 4096]

#include <cstdio>
#include <cstdlib>

#include "bench/sampling/cosine_lobe.h"
#include "bench/stopwatch.h"
#include "pbrt/build/build_scene.h"
#include "pbrt/render/render.h"
#include "pbrt/render/tile.h"
#include "pbrt/scene/parser.h"

namespace pbrt::bench {
namespace {

constexpr int kMostSamples = 256, kReferenceSeed = 1;

std::unique_ptr<RenderScene> Load(const char *fileName, int spp, int seed) {
    Diagnostics log;
    SceneDescription scene;
    scene.options.seed = seed;
    ParseFiles({fileName}, scene, log);
    Overrides overrides;
    overrides.spp = spp;
    overrides.film.quick = true;
    auto world = BuildScene(scene, overrides, log);
    for (const Message &m : log.Messages())
        std::fprintf(stderr, "%s\n", m.text.c_str());
    if (!world) std::exit(1);
    return world;
}

/// On this thread.
void RenderAlone(RenderScene &world, std::span<const ShadeGroup> groups) {
    RayCounts rays;
    std::visit(
        [&]<typename SamplerT>(const SamplerT &sampler) {
            const auto tracer = std::make_unique<BatchTracer<SamplerT>>(world, sampler, groups);
            RenderPixels(world, PixelsAlongCurve(world.film.Bounds()), sampler.SamplesPerPixel(),
                         *tracer, rays, [] { return true; });
        },
        world.sampler);
}

std::vector<double> Values(const RenderScene &world) {
    const PixelBounds b = world.film.Bounds();
    std::vector<double> values;
    for (int i = 0; i < b.Area(); ++i) {
        const RGB c = world.film.PixelRGB({b.x0 + i % b.Width(), b.y0 + i / b.Width()});
        values.insert(values.end(), {c.r, c.g, c.b});
    }
    return values;
}

double RelativeError(const std::vector<double> &values, const std::vector<double> &reference) {
    double squares = 0, sum = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        squares += Sqr(values[i] - reference[i]);
        sum += reference[i];
    }
    return std::sqrt(squares / values.size()) / (sum / values.size());
}

void Measure(const char *fileName, const char *way, LightStrategy strategy,
             std::span<const ShadeGroup> groups, const std::vector<double> &reference) {
    for (int spp = 1; spp <= kMostSamples; spp *= 4) {
        const auto world = Load(fileName, spp, 0);
        world->path.strategy = strategy;
        const double start = ThreadSeconds();
        RenderAlone(*world, groups);
        const double seconds = ThreadSeconds() - start;
        std::printf("%s,%d,%.4g,%.4g\n", way, spp, seconds,
                    RelativeError(Values(*world), reference));
        std::fflush(stdout);
    }
}

void Run(const char *fileName, int referenceSamples) {
    const auto world = Load(fileName, referenceSamples, kReferenceSeed);
    Render(*world, 0, [](int64_t, int64_t) { return true; });
    const std::vector<double> reference = Values(*world);
    std::printf("way,spp,seconds,rms_error\n");
    static constexpr auto byCosine = ShadeGroupsOf<FeathersByCosine>();
    Measure(fileName, "model", LightStrategy::Both, ShadeGroups(), reference);
    Measure(fileName, "cosine lobe", LightStrategy::Both, byCosine, reference);
    Measure(fileName, "lights only", LightStrategy::LightsOnly, ShadeGroups(), reference);
}

}  // namespace
}  // namespace pbrt::bench

int main(int argc, char **argv) {
    if (argc < 2) {
        std::fprintf(stderr, "bench_sampling scene.pbrt [reference's samples per pixel]\n");
        return 1;
    }
    pbrt::bench::Run(argv[1], argc > 2 ? std::max(1, std::atoi(argv[2])) : 4096);
}
