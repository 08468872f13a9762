// Error of a picture against the processor time spent on it, one thread, when feathers are sampled
// by their model, by a cosine lobe (both with light sampling, power heuristic), and with light
// sampling only. Writes CSV: way, samples per pixel, seconds, root-mean-square error of linear RGB
// over the picture, relative to the reference's mean.
//   bench_sampling scene.pbrt [reference's samples per pixel, default 4096]

#include <cstdio>
#include <cstdlib>

#include "bench/sampling/cosine_lobe.h"
#include "bench/stopwatch.h"
#include "pbrt/integrators/path/batch_tracer.h"
#include "pbrt/render/render.h"
#include "pbrt/scene/parser.h"

namespace pbrt::bench {
namespace {

constexpr int kMostSamples = 256, kReferenceSeed = 1;

RenderTask Load(const char *fileName, int spp, int seed) {
    Diagnostics log;
    SceneDescription description;
    description.options.seed = seed;
    ParseFiles({fileName}, description, log);
    Overrides overrides;
    overrides.spp = spp;
    overrides.film.quick = true;
    std::optional<RenderTask> task = MakeRenderTask(std::move(description), overrides, log);
    for (const Message &m : log.Messages())
        std::fprintf(stderr, "%s\n", m.text.c_str());
    if (!task) std::exit(1);
    return std::move(*task);
}

/// Renders on this thread.
Image RenderAlone(const RenderScene &scene, const PathSettings &settings,
                  std::span<const ShadeGroup> groups) {
    std::unique_ptr<Tracer> tracer =
        Dispatch(scene.sampler, [&]<typename S>(const S &sampler) -> std::unique_ptr<Tracer> {
            return std::make_unique<BatchTracer<S>>(scene, settings, sampler, groups);
        });
    const int spp = Dispatch(scene.sampler, [](const auto &s) { return s.SamplesPerPixel(); });
    RayCounts rays;
    Image image = scene.film.NewImage();
    for (const PixelBounds &tile : TilesOf(scene.film)) {
        const std::vector<Point2i> pixels = PixelsAlongCurve(tile);
        tracer->StartTile(pixels);
        std::vector<Film::Pixel> sums(pixels.size(), scene.film.NewPixel());
        for (SampleRange b = BlockAt(0, spp); b.Size() > 0; b = BlockAt(b.last, spp)) {
            const int together = kBatchSize / b.Size(), n = int(pixels.size());
            for (int p = 0; p < n; p += together)
                tracer->Trace({p, std::min(p + together, n), b.first, b.last}, sums, rays);
        }
        for (size_t i = 0; i < pixels.size(); ++i)
            scene.film.Develop(pixels[i], sums[i], &image);
    }
    return image;
}

/// Of films `rgb`.
double RelativeError(const Image &image, const Image &reference) {
    const std::vector<float> &values = image.Data(), &expected = reference.Data();
    double squares = 0, sum = 0;
    for (size_t i = 0; i < values.size(); ++i) {
        squares += Sqr(double(values[i]) - expected[i]);
        sum += expected[i];
    }
    return std::sqrt(squares / double(values.size())) / (sum / double(values.size()));
}

void Measure(const char *fileName, const char *way, LightStrategy strategy,
             std::span<const ShadeGroup> groups, const Image &reference) {
    for (int spp = 1; spp <= kMostSamples; spp *= 4) {
        const RenderTask task = Load(fileName, spp, 0);
        PathSettings settings;
        settings.strategy = strategy;
        settings.Preprocess(*task.scene);
        const double start = ThreadSeconds();
        const Image image = RenderAlone(*task.scene, settings, groups);
        const double seconds = ThreadSeconds() - start;
        std::printf("%s,%d,%.4g,%.4g\n", way, spp, seconds, RelativeError(image, reference));
        std::fflush(stdout);
    }
}

void Run(const char *fileName, int referenceSamples) {
    const RenderTask task = Load(fileName, referenceSamples, kReferenceSeed);
    Image reference;
    Render(
        task, 0, [](int64_t, int64_t) { return true; }, &reference);
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
