#include "pbrt/render/adaptive.h"

#include "pbrt/util/math.h"

namespace pbrt {

double RelativeSquaredError(std::span<const Film::Pixel> first, std::span<const Film::Pixel> all) {
    double sum = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const Film::Pixel &a = first[i], &whole = all[i];
        const double weight = whole.Weight(), weightA = a.Weight(), weightB = weight - weightA;
        // Of n samples of variance v: v / n, and means of parts differ by v n / (nA nB) in the
        // square.
        const double ratio = weightA * weightB / Sqr(weight);
        for (int c = 0; c < 3; ++c) {
            const double mean = whole.Mean(c), meanA = a.Mean(c);
            const double meanB = (mean * weight - meanA * weightA) / weightB;
            sum += Sqr(meanA - meanB) * ratio / (Sqr(mean) + 0.01);
        }
    }
    return sum / (3 * double(all.size()));
}

}  // namespace pbrt
