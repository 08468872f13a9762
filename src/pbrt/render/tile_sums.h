#pragma once

#include <span>
#include <vector>

#include "pbrt/render/pieces.h"

namespace pbrt {

/// Sums of an unfinished image, tile by tile: Film::SumsPerPixel() numbers a pixel, in the order of
/// PixelsAlongCurve. A tile takes memory from its first Store on.
class TileSums {
  public:
    /// The film must outlive it.
    explicit TileSums(const Film &film);

    const std::vector<PixelBounds> &Tiles() const { return tiles; }
    /// Pixels to add samples to; Store puts them back.
    std::vector<Film::Pixel> Load(size_t tile) const;
    void Store(size_t tile, std::span<const Film::Pixel> pixels);

    /// The sums one after another; empty: all are 0.
    const std::vector<ExactSum> &Flat(size_t tile) const { return sums[tile]; }
    std::vector<ExactSum> &Flat(size_t tile) { return sums[tile]; }
    /// How many a tile has that is not empty.
    size_t FlatSize(size_t tile) const { return size_t(tiles[tile].Area()) * perPixel; }

    /// Sets the pixels of one tile, or all, of an image like film.NewImage().
    void Develop(size_t tile, Image *image) const;
    void Develop(Image *image) const;

  private:
    const Film &film;
    std::vector<PixelBounds> tiles;
    size_t perPixel;
    std::vector<std::vector<ExactSum>> sums;
};

/// Pixels from sums that stand one after another, and back.
std::vector<Film::Pixel> UnflattenAll(const Film &film, std::span<const ExactSum> sums);
std::vector<ExactSum> FlattenAll(const Film &film, std::span<const Film::Pixel> pixels);

}  // namespace pbrt
