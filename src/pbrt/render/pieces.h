#pragma once

#include <algorithm>
#include <vector>

#include "pbrt/films/film.h"

namespace pbrt {

// An image is rendered in pieces: some samples of one tile. Their borders are the same whatever
// part of the image is wanted, by however many threads or machines, in whatever order: what shares
// a batch of paths shares their roundings (integrators/path/batch_tracer.h), and sums are exact
// (films/exact_sum.h). So any split of a render gives the same bits, pixel by pixel.

/// Tiles are squares of so many pixels, from the full image's corner on; at its right and lower
/// edge they are cut off, at the borders of a crop window they are not. Small enough that threads
/// end together, large enough for batches of one sample a pixel.
inline constexpr int kTileSize = 16;
/// The pixels of all tiles that touch the film's Bounds(), row by row; those outside it included.
std::vector<PixelBounds> TilesOf(const Film &film);
/// A tile's pixels along a Z-curve: neighbours share batches.
std::vector<Point2i> PixelsAlongCurve(const PixelBounds &tile);

/// Samples [first, last) of each pixel.
struct SampleRange {
    int first = 0, last = 0;
    int Size() const { return last - first; }
    bool operator==(const SampleRange &) const = default;
};
/// Samples come in blocks that end after 1, 4, 16, 32, 64, 128, 192 ...: a preview is there soon,
/// and few samples are in small blocks. Small ones make small batches and spread packets over many
/// pixels: with ends after 1, 2, 4, 8, 16 images of 16 samples took 2 to 3 % longer.
inline constexpr int kLargestBlock = 64;
/// The block that begins at `first`, where one does, of `spp` samples in all.
inline SampleRange BlockAt(int first, int spp) {
    const int last = first == 0   ? 1
                     : first < 16 ? 4 * first
                                  : std::min(2 * first, first + kLargestBlock);
    return {first, std::min(spp, last)};
}

/// A unit of work: a block of samples of a tile.
struct Piece {
    size_t tile;  ///< index into TilesOf(film)
    SampleRange samples;
};
/// All pieces of an image, block by block.
std::vector<Piece> PiecesOf(const Film &film, int spp);

}  // namespace pbrt
