#include "pbrt/render/tile.h"

#include <algorithm>

#include "pbrt/util/math.h"

namespace pbrt {

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

}  // namespace pbrt
