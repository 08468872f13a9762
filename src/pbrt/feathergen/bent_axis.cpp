#include "pbrt/feathergen/bent_axis.h"

namespace pbrt::feathergen {

AxisFrame BentAxis::At(double u) const {
    const double a = Azimuth(u), e = Elevation(u);
    const Vec3d level = std::cos(a) * base.forward + std::sin(a) * base.left;
    return {std::cos(e) * level + std::sin(e) * base.up,
            std::cos(a) * base.left - std::sin(a) * base.forward,
            std::cos(e) * base.up - std::sin(e) * level};
}

Vec3d BentAxis::Point(double u) const {
    // Gauss-Legendre with 8 nodes on [-1, 1] (positive half; Abramowitz & Stegun table 25.4).
    constexpr double kNodes[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                 0.9602898564975363};
    constexpr double kWeights[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                   0.1012285362903763};
    Vec3d sum;
    for (int i = 0; i < 4; ++i)
        sum += kWeights[i] *
               (At(u / 2 * (1 - kNodes[i])).forward + At(u / 2 * (1 + kNodes[i])).forward);
    return root + (length * u / 2) * sum;
}

}  // namespace pbrt::feathergen
