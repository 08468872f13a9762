#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "pbrt/base/integrator.h"
#include "pbrt/render/tile_sums.h"

namespace pbrt {

struct RenderTask;

struct RenderStats {
    double seconds = 0;
    int64_t cameraSamples = 0;   ///< traced, pixels around a crop window included
    double samplesPerPixel = 0;  ///< mean over the image
    RayCounts rays;
};

/// An image between its first sample and its last: what threads add pieces to, and what others look
/// at meanwhile. All functions may be called from any thread.
class RenderState {
  public:
    /// Nothing is rendered yet. The task must outlive it.
    explicit RenderState(const RenderTask &task);

    /// The state of a tile beside its sums.
    struct Tile {
        int next = 0;                  ///< samples up to this one are in it
        bool enough = false;           ///< its error is as small as wanted: it gets no more
        std::vector<ExactSum> before;  ///< with a target error: the sums at its last judgement
        // For --pixelstats.
        double seconds = 0;  ///< of all threads
        int64_t rays = 0;
    };

    const std::vector<PixelBounds> &Tiles() const { return sums.Tiles(); }
    /// The samples that each pixel is to get.
    SampleRange Samples() const { return range; }

    // For the one thread that works on a tile.
    std::vector<Film::Pixel> Load(size_t tile) const { return sums.Load(tile); }
    const Tile &TileAt(size_t tile) const { return tiles[tile]; }
    /// Ends a piece: its sums and `after`.
    void Store(size_t tile, std::span<const Film::Pixel> pixels, const Tile &after,
               const RayCounts &rays);
    /// The clock of the stats runs while one lives.
    class Clock;

    /// Samples of all tiles' pixels, those that a tile does not need counted as done.
    struct Progress {
        int64_t done = 0, total = 0;
        int64_t rays = 0;
    };
    Progress HowFar() const;
    RenderStats Stats() const;

    /// Calls see(sums, tiles), const both, while nothing changes.
    template <typename F>
    void Look(const F &see) const {
        const std::scoped_lock lock(mutex);
        see(sums, tiles);
    }
    /// The same to change them, as of a checkpoint; `earlier` counts into the stats.
    template <typename F>
    void Restore(const RenderStats &earlier, const F &change) {
        const std::scoped_lock lock(mutex);
        change(sums, tiles);
        stats = earlier;
        CountSamples();
    }

    /// The image of the samples so far; black where there are none.
    Image Develop() const;
    /// Least and most samples of a pixel so far. A tile that needs no more counts as it is.
    SampleRange Spread() const;

  private:
    friend class Clock;
    void CountSamples();
    double SecondsNow() const;

    const RenderTask &task;
    SampleRange range;
    mutable std::mutex mutex;  ///< for all below but atomics
    TileSums sums;
    std::vector<Tile> tiles;
    RenderStats stats;  ///< but for samplesPerPixel; seconds up to the clock's start
    std::optional<int64_t> clockStart;  ///< ns
    int64_t wanted = 0;                 ///< samples of the pixels inside the film's bounds
    std::atomic<int64_t> done{0}, total{0}, rays{0};
};

class RenderState::Clock {
  public:
    explicit Clock(RenderState *state);
    ~Clock();
    Clock(const Clock &) = delete;
    Clock &operator=(const Clock &) = delete;

  private:
    RenderState *state;
};

}  // namespace pbrt
