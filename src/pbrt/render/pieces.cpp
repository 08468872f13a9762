#include "pbrt/render/pieces.h"

#include "pbrt/util/math.h"

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
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x)
            pixels.push_back({x, y});
    std::sort(pixels.begin(), pixels.end(), [](Point2i a, Point2i b) {
        return EncodeMorton2(uint32_t(a.x), uint32_t(a.y)) <
               EncodeMorton2(uint32_t(b.x), uint32_t(b.y));
    });
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
