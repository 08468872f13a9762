#include "pbrt/render/render_state.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "pbrt/render/render.h"

namespace pbrt {
namespace {

int64_t Nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Pixels of a tile that are wanted.
int64_t PixelsInside(const PixelBounds &tile, const PixelBounds &bounds) {
    const int64_t width = std::min(tile.x1, bounds.x1) - std::max(tile.x0, bounds.x0);
    const int64_t height = std::min(tile.y1, bounds.y1) - std::max(tile.y0, bounds.y0);
    return width * height;
}

}  // namespace

RenderState::RenderState(const RenderTask &task)
    : task(task), range(task.Samples()), sums(task.scene->film), tiles(sums.Tiles().size()) {
    for (Tile &tile : tiles)
        tile.next = range.first;
    CountSamples();
}

void RenderState::CountSamples() {
    int64_t samples = 0, traced = 0, planned = 0;
    wanted = 0;
    const PixelBounds &bounds = task.scene->film.Bounds();
    for (size_t i = 0; i < tiles.size(); ++i) {
        const PixelBounds &tile = sums.Tiles()[i];
        const int64_t each = tiles[i].next - range.first;
        traced += each * tile.Area();
        samples += (tiles[i].enough ? range.Size() : each) * tile.Area();
        planned += range.Size() * tile.Area();
        wanted += each * PixelsInside(tile, bounds);
    }
    done = samples;
    total = planned;
    rays = stats.rays.closest + stats.rays.shadow;
    stats.cameraSamples = traced;
}

void RenderState::Store(size_t tile, std::span<const Film::Pixel> pixels, const Tile &after,
                        const RayCounts &traced) {
    const PixelBounds &bounds = sums.Tiles()[tile];
    const std::scoped_lock lock(mutex);
    const int64_t more = after.next - tiles[tile].next;
    sums.Store(tile, pixels);
    tiles[tile] = after;
    stats.rays += traced;
    stats.cameraSamples += more * bounds.Area();
    wanted += more * PixelsInside(bounds, task.scene->film.Bounds());
    done += (more + (after.enough ? range.last - after.next : 0)) * bounds.Area();
    rays += traced.closest + traced.shadow;
}

RenderState::Progress RenderState::HowFar() const {
    return {done, total, rays};
}

RenderStats RenderState::Stats() const {
    const std::scoped_lock lock(mutex);
    RenderStats now = stats;
    now.seconds = SecondsNow();
    now.samplesPerPixel = double(wanted) / double(task.scene->film.Bounds().Area());
    return now;
}

Image RenderState::Develop() const {
    Image image = task.scene->film.NewImage();
    const std::scoped_lock lock(mutex);
    sums.Develop(&image);
    return image;
}

SampleRange RenderState::Spread() const {
    const std::scoped_lock lock(mutex);
    SampleRange spread{std::numeric_limits<int>::max(), 0};
    for (const Tile &tile : tiles) {
        spread.first = std::min(spread.first, tile.next - range.first);
        spread.last = std::max(spread.last, tile.next - range.first);
    }
    return spread;
}

double RenderState::SecondsNow() const {
    return stats.seconds + (clockStart ? double(Nanoseconds() - *clockStart) * 1e-9 : 0);
}

RenderState::Clock::Clock(RenderState *state) : state(state) {
    const std::scoped_lock lock(state->mutex);
    state->clockStart = Nanoseconds();
}

RenderState::Clock::~Clock() {
    const std::scoped_lock lock(state->mutex);
    state->stats.seconds = state->SecondsNow();
    state->clockStart.reset();
}

}  // namespace pbrt
