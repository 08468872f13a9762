#pragma once

#include "pbrt/image/image.h"

namespace pbrt::imgtool {

/// Z-scores of the means of square tiles, per channel, against a reference of known noise.
struct TileScores {
    int scores = 0;       ///< tiles times channels
    int beyond = 0;       ///< |z| > bound: more than chance explains
    double bound = 0;     ///< |z| that any of `scores` exceeds with probability `significance`
    double meanZ = 0;     ///< about +-1 / sqrt(scores) where both are right
    double rmsZ = 0;      ///< about 1 where both are right and the variance is known well
    double worstZ = 0;    ///< the largest |z|, with its sign
    Point2i worstTile{};  ///< its first pixel
};

/// z of a two-sided test such that the largest of `n` independent standard normal numbers exceeds
/// it with probability `significance` (Sidak 1967).
double SidakBound(int n, double significance);

/// `variance` is that of each value of `reference`; the variance of `image` is `ratio` times as
/// much (the ratio of the numbers of samples). Rounding to the stored format is added, so that
/// pixels without noise may differ by it. The three images match; tiles at the right and lower
/// edges may be smaller than `tileSize`.
TileScores CompareTiles(const Image &image, const Image &reference, const Image &variance,
                        double ratio, int tileSize, double significance);

}  // namespace pbrt::imgtool
