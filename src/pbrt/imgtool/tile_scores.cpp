#include "pbrt/imgtool/tile_scores.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pbrt::imgtool {
namespace {

/// Variance of the error that storing a value adds: uniform within one step of half, or the
/// rounding of a long sum in float.
double RoundingVariance(const Image &image, double value) {
    constexpr double kFloat = 1e-6;
    const bool half = image.metadata.storedAs == "half";
    return value * value * (half ? 0x1p-20 / 12 : kFloat * kFloat);
}

double TileZ(const Image &image, const Image &reference, const Image &variance, double ratio,
             Point2i p0, Point2i p1, int channel) {
    double difference = 0, sumVariance = 0;
    for (int y = p0.y; y < p1.y; ++y)
        for (int x = p0.x; x < p1.x; ++x) {
            const double a = image.Get({x, y}, channel), b = reference.Get({x, y}, channel);
            difference += a - b;
            sumVariance += (1 + ratio) * variance.Get({x, y}, channel) +
                           RoundingVariance(image, a) + RoundingVariance(reference, b);
        }
    if (difference == 0) return 0;
    const double z = difference / std::sqrt(std::max(0., sumVariance));
    // Not finite pixels fail; so do differences where no noise is expected.
    return std::isnan(z) ? std::numeric_limits<double>::infinity() : z;
}

}  // namespace

double SidakBound(int n, double significance) {
    const double each = -std::expm1(std::log1p(-significance) / n);
    double low = 0, high = 40;  // erfc(z / sqrt 2) falls from 1 to 0 between them
    for (int i = 0; i < 100; ++i) {
        const double z = (low + high) / 2;
        (std::erfc(z / std::sqrt(2.)) > each ? low : high) = z;
    }
    return high;
}

TileScores CompareTiles(const Image &image, const Image &reference, const Image &variance,
                        double ratio, int tileSize, double significance) {
    const auto [width, height] = image.Resolution();
    const auto tiles = [&](int size) { return (size + tileSize - 1) / tileSize; };
    TileScores test;
    test.scores = tiles(width) * tiles(height) * image.NChannels();
    test.bound = SidakBound(test.scores, significance);
    double sum = 0, sumSquares = 0;
    for (int y = 0; y < height; y += tileSize)
        for (int x = 0; x < width; x += tileSize)
            for (int c = 0; c < image.NChannels(); ++c) {
                const Point2i end{std::min(width, x + tileSize), std::min(height, y + tileSize)};
                const double z = TileZ(image, reference, variance, ratio, {x, y}, end, c);
                sum += z;
                sumSquares += z * z;
                if (std::abs(z) > test.bound) ++test.beyond;
                if (std::abs(z) <= std::abs(test.worstZ)) continue;
                test.worstZ = z;
                test.worstTile = {x, y};
            }
    test.meanZ = sum / test.scores;
    test.rmsZ = std::sqrt(sumSquares / test.scores);
    return test;
}

}  // namespace pbrt::imgtool
