#include "pbrt/render/tile_sums.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace pbrt {

std::vector<Film::Pixel> UnflattenAll(const Film &film, std::span<const ExactSum> sums) {
    const size_t perPixel = film.SumsPerPixel();
    std::vector<Film::Pixel> pixels;
    pixels.reserve(sums.size() / perPixel);
    for (size_t at = 0; at < sums.size(); at += perPixel)
        pixels.push_back(film.Unflatten(&sums[at]));
    return pixels;
}

std::vector<ExactSum> FlattenAll(const Film &film, std::span<const Film::Pixel> pixels) {
    const size_t perPixel = film.SumsPerPixel();
    std::vector<ExactSum> sums(pixels.size() * perPixel);
    for (size_t i = 0; i < pixels.size(); ++i)
        film.Flatten(pixels[i], &sums[i * perPixel]);
    return sums;
}

TileSums::TileSums(const Film &film)
    : film(film), tiles(TilesOf(film)), perPixel(film.SumsPerPixel()), sums(tiles.size()) {}

std::vector<Film::Pixel> TileSums::Load(size_t tile) const {
    if (sums[tile].empty()) return {size_t(tiles[tile].Area()), film.NewPixel()};
    return UnflattenAll(film, sums[tile]);
}

void TileSums::Store(size_t tile, std::span<const Film::Pixel> pixels) {
    sums[tile] = FlattenAll(film, pixels);
}

void TileSums::Develop(size_t tile, Image *image) const {
    const std::vector<Film::Pixel> values = Load(tile);
    const std::vector<Point2i> pixels = PixelsAlongCurve(tiles[tile]);
    for (size_t i = 0; i < pixels.size(); ++i)
        if (film.Bounds().Contains(pixels[i])) film.Develop(pixels[i], values[i], image);
}

void TileSums::Develop(Image *image) const {
    // Alone: a thread that waits for the others must not take up work of theirs, which may want a
    // lock that this one's caller holds.
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(size_t(0), tiles.size(), [&](size_t tile) { Develop(tile, image); });
    });
}

}  // namespace pbrt
