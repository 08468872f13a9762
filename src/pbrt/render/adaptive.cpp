#include "pbrt/render/adaptive.h"

namespace pbrt {

double RelativeSquaredError(std::span<const Film::Pixel> firstHalf,
                            std::span<const Film::Pixel> all) {
    double sum = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const Film::Pixel &a = firstHalf[i], &whole = all[i];
        const double weightB = whole.weight - a.weight;
        for (int c = 0; c < 3; ++c) {
            const double mean = whole.rgb[c] / whole.weight;
            const double error = (a.rgb[c] / a.weight - (whole.rgb[c] - a.rgb[c]) / weightB) / 2;
            sum += Sqr(error) / (Sqr(mean) + 0.01);
        }
    }
    return sum / (3 * double(all.size()));
}

}  // namespace pbrt
