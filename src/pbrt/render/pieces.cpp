#include "pbrt/render/pieces.h"

namespace pbrt {

std::vector<PixelBounds> TilesOf(const Film &film) {
    const PixelBounds &b = film.Bounds();
    const Point2i full = film.FullResolution();
    std::vector<PixelBounds> tiles;
    for (int y = b.y0 / kTileSize * kTileSize; y < b.y1; y += kTileSize)
        for (int x = b.x0 / kTileSize * kTileSize; x < b.x1; x += kTileSize)
            tiles.push_back(
                {x, std::min(x + kTileSize, full.x), y, std::min(y + kTileSize, full.y)});
    return tiles;
}

std::vector<Point2i> PixelsAlongCurve(const PixelBounds &tile) {
    std::vector<Point2i> pixels;
    pixels.reserve(size_t(tile.Area()));
    // Bits of x and y in turns are a place on the curve; all of a whole tile, though this be less.
    for (int place = 0; place < kTileSize * kTileSize; ++place) {
        Point2i p{tile.x0, tile.y0};
        for (int bit = 0; 1 << bit < kTileSize; ++bit) {
            p.x += (place >> (2 * bit) & 1) << bit;
            p.y += (place >> (2 * bit + 1) & 1) << bit;
        }
        if (tile.Contains(p)) pixels.push_back(p);
    }
    return pixels;
}

std::vector<Piece> PiecesOf(const Film &film, int spp) {
    const size_t tiles = TilesOf(film).size();
    std::vector<Piece> pieces;
    for (SampleRange block = BlockAt(0, spp); block.Size() > 0; block = BlockAt(block.last, spp))
        for (size_t tile = 0; tile < tiles; ++tile)
            pieces.push_back({tile, block});
    return pieces;
}

}  // namespace pbrt
