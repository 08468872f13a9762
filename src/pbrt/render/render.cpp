#include "pbrt/render/render.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <mutex>

#include "pbrt/render/adaptive.h"

namespace pbrt {
namespace {

/// The threads' tracers, and the tiles they share out.
class TileLoop {
  public:
    /// `planned`: samples of the whole render, for progress.
    TileLoop(const RenderTask &task, int nThreads, int64_t planned, const RenderProgress &progress)
        : task(task),
          film(task.scene->film),
          tiles(TilesOf(film)),
          planned(planned),
          progress(progress),
          arena(nThreads > 0 ? nThreads : tbb::task_arena::automatic),
          tracers([&task] { return MakeTracer(task.integrator, *task.scene); }) {}

    bool Stopped() const { return stopped; }

    /// A tile in the hands of one thread.
    struct Work {
        std::span<const Point2i> pixels;
        Tracer &tracer;
        RayCounts rays;
    };
    /// Calls render(tile index, work) for each tile; it returns how many samples a pixel got.
    template <typename F>
    void ForEachTile(const F &render) {
        arena.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<size_t>(0, tiles.size()),
                [&](const tbb::blocked_range<size_t> &range) {
                    for (size_t i = range.begin(); i != range.end(); ++i)
                        RenderTile(i, render);
                },
                tbb::simple_partitioner());
        });
    }

    /// Adds a block of samples in batches; less where progress, asked before each, says no.
    void Trace(SampleRange block, std::span<Film::Pixel> sums, Work *work) {
        const int n = int(work->pixels.size()), together = kBatchSize / block.Size();
        for (int first = 0; first < n && KeepGoing(); first += together)
            work->tracer.Trace({first, std::min(first + together, n), block.first, block.last},
                               sums, work->rays);
    }

    /// Counts samples that were planned and are not needed.
    void Skip(int64_t samples) { done += samples; }

    /// After the loop.
    RenderStats Stats() const {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        return {time.count(), samples, double(wanted) / double(film.Bounds().Area()), rays};
    }

  private:
    template <typename F>
    void RenderTile(size_t i, const F &render) {
        const std::vector<Point2i> pixels = PixelsAlongCurve(tiles[i]);
        Work work{pixels, *tracers.local(), {}};
        work.tracer.StartTile(pixels);
        const int64_t spp = render(i, &work);
        const auto inside = std::count_if(pixels.begin(), pixels.end(),
                                          [&](Point2i p) { return film.Bounds().Contains(p); });
        samples += spp * int64_t(pixels.size());
        wanted += spp * inside;
        done += spp * int64_t(pixels.size());
        const std::scoped_lock lock(mutex);
        rays += work.rays;
        KeepGoing();
    }
    bool KeepGoing() {
        if (!progress(done, planned)) stopped = true;
        return !stopped;
    }

    const RenderTask &task;
    const Film &film;
    std::vector<PixelBounds> tiles;
    int64_t planned;
    const RenderProgress &progress;
    tbb::task_arena arena;
    tbb::enumerable_thread_specific<std::unique_ptr<Tracer>> tracers;
    std::atomic<int64_t> done{0}, samples{0}, wanted{0};
    std::mutex mutex;
    RayCounts rays;  ///< of finished tiles; guarded by mutex
    std::atomic<bool> stopped{false};
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

void DevelopTile(const Film &film, const PixelBounds &tile, std::span<const Film::Pixel> sums,
                 Image *image) {
    const std::vector<Point2i> pixels = PixelsAlongCurve(tile);
    for (size_t i = 0; i < pixels.size(); ++i)
        if (film.Bounds().Contains(pixels[i])) film.Develop(pixels[i], sums[i], image);
}

/// Renders a tile to its end, or to the target error; the samples a pixel got.
int RenderTile(const RenderTask &task, TileLoop &loop, std::span<Film::Pixel> sums,
               TileLoop::Work *work) {
    const int spp = task.SamplesPerPixel();
    std::vector<Film::Pixel> before;
    for (SampleRange block = BlockAt(0, spp); block.Size() > 0; block = BlockAt(block.last, spp)) {
        loop.Trace(block, sums, work);
        if (task.targetError <= 0 || !std::has_single_bit(unsigned(block.last))) continue;
        if (block.last >= kFirstJudgement &&
            RelativeSquaredError(before, sums) <= Sqr(task.targetError)) {
            loop.Skip((spp - block.last) * int64_t(sums.size()));
            return block.last;
        }
        before.assign(sums.begin(), sums.end());
    }
    return spp;
}

int64_t PlannedSamples(const std::vector<PixelBounds> &tiles, int spp) {
    int64_t pixels = 0;
    for (const PixelBounds &tile : tiles)
        pixels += tile.Area();
    return pixels * spp;
}

}  // namespace

int RenderTask::SamplesPerPixel() const {
    return Dispatch(scene->sampler, [](const auto &s) { return s.SamplesPerPixel(); });
}

std::optional<RenderTask> MakeRenderTask(SceneDescription &&description, const Overrides &overrides,
                                         Diagnostics &log) {
    if (IsOld(log)) return {};
    RenderTask task;
    task.integrator = CreateIntegrator(description, log);
    task.targetError = overrides.targetError;
    task.scene = BuildScene(std::move(description), overrides, log);
    if (!task.scene || log.HasErrors()) return {};
    Dispatch(task.integrator, [&]<typename I>(I &integrator) {
        integrator.Preprocess(*task.scene);
        if (I::kTraits.usesLights && task.scene->lights.empty())
            log.Warning({}, "no light sources in the scene: the picture is black");
    });
    return task;
}

TileSums::TileSums(const Film &film) {
    for (const PixelBounds &tile : TilesOf(film))
        sums.emplace_back(size_t(tile.Area()), film.NewPixel());
}

void TileSums::Develop(const Film &film, Image *image) const {
    const std::vector<PixelBounds> tiles = TilesOf(film);
    for (size_t i = 0; i < tiles.size(); ++i)
        DevelopTile(film, tiles[i], sums[i], image);
}

std::optional<RenderStats> AddPieces(const RenderTask &task, std::span<const Piece> pieces,
                                     int nThreads, const RenderProgress &progress, TileSums *sums) {
    const std::vector<PixelBounds> tiles = TilesOf(task.scene->film);
    std::vector<std::vector<SampleRange>> blocks(tiles.size());
    int64_t planned = 0;
    for (const Piece &piece : pieces) {
        blocks[piece.tile].push_back(piece.samples);
        planned += piece.samples.Size() * tiles[piece.tile].Area();
    }
    TileLoop loop(task, nThreads, planned, progress);
    loop.ForEachTile([&](size_t tile, TileLoop::Work *work) {
        int spp = 0;
        for (const SampleRange &block : blocks[tile]) {
            loop.Trace(block, (*sums)[tile], work);
            spp += block.Size();
        }
        return spp;
    });
    if (loop.Stopped()) return {};
    return loop.Stats();
}

std::optional<RenderStats> Render(const RenderTask &task, int nThreads,
                                  const RenderProgress &progress, Image *image,
                                  const std::function<void(int)> &afterPass) {
    const Film &film = task.scene->film;
    const int spp = task.SamplesPerPixel();
    const std::vector<PixelBounds> tiles = TilesOf(film);
    TileLoop loop(task, nThreads, PlannedSamples(tiles, spp), progress);
    *image = film.NewImage();
    if (!afterPass) {
        loop.ForEachTile([&](size_t tile, TileLoop::Work *work) {
            std::vector<Film::Pixel> sums(work->pixels.size(), film.NewPixel());
            const int got = RenderTile(task, loop, sums, work);
            DevelopTile(film, tiles[tile], sums, image);
            return got;
        });
    } else {
        TileSums sums(film);
        for (SampleRange block = BlockAt(0, spp); block.Size() > 0 && !loop.Stopped();
             block = BlockAt(block.last, spp)) {
            loop.ForEachTile([&](size_t tile, TileLoop::Work *work) {
                loop.Trace(block, sums[tile], work);
                return block.Size();
            });
            if (loop.Stopped()) break;
            sums.Develop(film, image);
            afterPass(block.last);
        }
    }
    if (loop.Stopped()) return {};
    return loop.Stats();
}

}  // namespace pbrt
