#include "pbrt/render/render.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <bit>
#include <chrono>

#include "pbrt/render/adaptive.h"

namespace pbrt {
namespace {

/// The threads' tracers, and the tiles they share out.
class TileLoop {
  public:
    TileLoop(const RenderTask &task, int nThreads)
        : tiles(TilesOf(task.scene->film)),
          arena(nThreads > 0 ? nThreads : tbb::task_arena::automatic),
          tracers([&task] { return MakeTracer(task.integrator, *task.scene); }) {}

    /// A tile in the hands of one thread.
    struct Work {
        std::span<const Point2i> pixels;
        Tracer &tracer;
        RayCounts rays;
    };
    /// Calls wanted(tile index) and, where that is true, render(tile index, work) for each tile.
    template <typename Wanted, typename F>
    void ForEachTile(const Wanted &wanted, const F &render) {
        arena.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<size_t>(0, tiles.size()),
                [&](const tbb::blocked_range<size_t> &range) {
                    for (size_t i = range.begin(); i != range.end(); ++i) {
                        if (!wanted(i)) continue;
                        const std::vector<Point2i> pixels = PixelsAlongCurve(tiles[i]);
                        Work work{pixels, *tracers.local(), {}};
                        work.tracer.StartTile(pixels);
                        render(i, &work);
                    }
                },
                tbb::simple_partitioner());
        });
    }

    /// Runs f by one of the threads, which may share its work.
    template <typename F>
    void Execute(const F &f) {
        arena.execute(f);
    }

  private:
    std::vector<PixelBounds> tiles;
    tbb::task_arena arena;
    tbb::enumerable_thread_specific<std::unique_ptr<Tracer>> tracers;
};

/// Adds a block of samples in batches; false where goOn(), asked before each, says no.
template <typename F>
bool Trace(SampleRange block, std::span<Film::Pixel> sums, TileLoop::Work *work, const F &goOn) {
    const int n = int(work->pixels.size()), together = kBatchSize / block.Size();
    for (int first = 0; first < n; first += together) {
        if (!goOn()) return false;
        work->tracer.Trace({first, std::min(first + together, n), block.first, block.last}, sums,
                           work->rays);
    }
    return true;
}

/// Judges a tile with a target error, whose sums have reached `tile.next` samples.
void Judge(const RenderTask &task, std::span<const Film::Pixel> sums, RenderState::Tile *tile) {
    if (task.targetError <= 0 || !std::has_single_bit(unsigned(tile->next))) return;
    const Film &film = task.scene->film;
    if (tile->next >= kFirstJudgement)
        tile->enough =
            RelativeSquaredError(UnflattenAll(film, tile->before), sums) <= Sqr(task.targetError);
    tile->before = tile->enough ? std::vector<ExactSum>() : FlattenAll(film, sums);
}

/// End of a pass over all tiles where nobody waits for the image of each block. Tiles begin anew
/// in each, which took 1 to 3 % of the time when a pass was a block; the first ends soon, so that
/// what is finished shows the whole image.
int PassEnd(int first) {
    constexpr int kFirstPass = 16;
    return first < kFirstPass ? kFirstPass : first - first % kLargestBlock + kLargestBlock;
}

/// The block that begins where one of `range`'s does, cut off at its end.
SampleRange BlockOf(SampleRange range, int first, int spp) {
    const SampleRange block = BlockAt(first, spp);
    return {block.first, std::min(block.last, range.last)};
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
    task.part = overrides.part;
    task.scene = BuildScene(std::move(description), overrides, log);
    if (!task.scene || log.HasErrors()) return {};
    Dispatch(task.integrator, [&]<typename I>(I &integrator) {
        integrator.Preprocess(*task.scene);
        if (I::kTraits.usesLights && task.scene->lights.empty())
            log.Warning({}, "no light sources in the scene: the picture is black");
    });
    return task;
}

bool GoOnRendering(const RenderTask &task, int nThreads, const RenderHooks &hooks,
                   RenderState *state) {
    const RenderState::Clock clock(state);
    const SampleRange range = state->Samples();
    const int spp = task.SamplesPerPixel();
    TileLoop loop(task, nThreads);
    std::atomic<bool> stopped = false;
    const auto goOn = [&] {
        const RenderState::Progress now = state->HowFar();
        if (!hooks.progress(now.done, now.total)) stopped = true;
        return !stopped;
    };
    for (int first = range.first; first < range.last && !stopped;) {
        const int end = hooks.afterPass ? BlockOf(range, first, spp).last
                                        : std::min(PassEnd(first), range.last);
        const auto wanted = [&](size_t i) {
            const RenderState::Tile &tile = state->TileAt(i);
            return !stopped && tile.next >= first && tile.next < end && !tile.enough;
        };
        loop.ForEachTile(wanted, [&](size_t i, TileLoop::Work *work) {
            std::vector<Film::Pixel> sums = state->Load(i);
            RenderState::Tile tile = state->TileAt(i);
            while (tile.next < end && !tile.enough) {
                const auto start = std::chrono::steady_clock::now();
                const SampleRange block = BlockOf(range, tile.next, spp);
                work->rays = {};
                if (!Trace(block, sums, work, goOn)) return;
                tile.next = block.last;
                Judge(task, sums, &tile);
                tile.rays += work->rays.closest + work->rays.shadow;
                tile.seconds +=
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                state->Store(i, sums, tile, work->rays);
                if (hooks.afterPiece) hooks.afterPiece();
                if (!goOn()) return;
            }
        });
        first = end;
        if (!stopped && hooks.afterPass) loop.Execute([&] { hooks.afterPass(first); });
    }
    const RenderState::Progress end = state->HowFar();
    return end.done == end.total;
}

std::optional<RenderStats> Render(const RenderTask &task, int nThreads,
                                  const RenderProgress &progress, Image *image,
                                  const std::function<void(int)> &afterPass) {
    RenderState state(task);
    RenderHooks hooks{progress};
    if (afterPass)
        hooks.afterPass = [&](int samples) {
            *image = state.Develop();
            afterPass(samples);
        };
    if (!GoOnRendering(task, nThreads, hooks, &state)) return {};
    *image = state.Develop();
    return state.Stats();
}

std::optional<RenderStats> AddPieces(const RenderTask &task, std::span<const Piece> pieces,
                                     int nThreads, const RenderProgress &progress, TileSums *sums) {
    const std::vector<PixelBounds> &tiles = sums->Tiles();
    std::vector<std::vector<SampleRange>> blocks(tiles.size());
    int64_t planned = 0;
    for (const Piece &piece : pieces) {
        blocks[piece.tile].push_back(piece.samples);
        planned += piece.samples.Size() * tiles[piece.tile].Area();
    }
    std::atomic<int64_t> done = 0;
    std::atomic<bool> stopped = false;
    const auto goOn = [&] {
        if (!progress(done, planned)) stopped = true;
        return !stopped;
    };
    TileLoop loop(task, nThreads);
    const auto wanted = [&](size_t i) { return !stopped && !blocks[i].empty(); };
    loop.ForEachTile(wanted, [&](size_t i, TileLoop::Work *work) {
        std::vector<Film::Pixel> pixels = sums->Load(i);
        for (const SampleRange &block : blocks[i]) {
            if (!Trace(block, pixels, work, goOn)) return;
            done += block.Size() * tiles[i].Area();
        }
        sums->Store(i, pixels);
    });
    if (stopped) return {};
    RenderStats stats;
    stats.cameraSamples = done;
    return stats;
}

}  // namespace pbrt
