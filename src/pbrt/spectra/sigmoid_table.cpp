#include "pbrt/spectra/sigmoid_table.h"

#include <tbb/parallel_for.h>

namespace pbrt {
namespace {

/// Position in [0, 1] of a component's value: the grid is denser near 0 and 1, where sigmoids
/// change fastest.
float PositionOfGreatest(float z) {
    const float root = std::sqrt(z);
    return 0.4f * root + 0.2f * std::sqrt(root) + 0.4f * (1 - std::sqrt(1 - z));
}
/// The same for a component relative to the greatest.
float PositionOfRatio(float x) {
    return 0.7f * std::sqrt(x) + 0.3f * x;
}
/// The value in [0, 1] at a position.
double Invert(float (*position)(float), double at) {
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (position(float(middle)) < at ? low : high) = middle;
    }
    return high;
}

float StoredScale(float mean) {
    return 2 * std::sqrt(mean * (1 - mean));
}
/// x of the constant spectrum `value`.
double GreyParameter(double value) {
    return (value - 0.5) / std::sqrt(value * (1 - value));
}

struct Cell {
    int index;
    float fraction;
};
Cell CellAt(float position, int count) {
    const float scaled = position * float(count - 1);
    const int index = std::min(int(scaled), count - 2);
    return {index, scaled - float(index)};
}

}  // namespace

SigmoidTable::SigmoidTable(const SigmoidFit &fit,
                           const std::function<Triple(const Triple &)> &xyzOf)
    : nodes(Index(3, 0, 0, 0)) {
    tbb::parallel_for(0, 3 * XYCount * XYCount, [&](int i) {
        FillColumn(fit, xyzOf, i / (XYCount * XYCount), i / XYCount % XYCount, i % XYCount);
    });
}

void SigmoidTable::FillColumn(const SigmoidFit &fit,
                              const std::function<Triple(const Triple &)> &xyzOf, int greatest,
                              int y, int x) {
    const double xRatio = Invert(PositionOfRatio, x / (XYCount - 1.0));
    const double yRatio = Invert(PositionOfRatio, y / (XYCount - 1.0));
    const auto fill = [&](int z, const SigmoidParameters *start) {
        // Black has no sigmoid; the stored product has a limit there.
        double value = std::max(1e-4, Invert(PositionOfGreatest, z / (ZCount - 1.0)));
        // Brighter than any look-up reaches: such nodes stay what the one below is.
        value = std::min(value, 1.9 / (1 + xRatio + yRatio));
        const double mean = value * (1 + xRatio + yRatio) / 3;
        SigmoidParameters p{0, 0, GreyParameter(mean)};
        if (xRatio < 1 || yRatio < 1) {
            Triple rgb;
            rgb[greatest] = value;
            rgb[(greatest + 1) % 3] = xRatio * value;
            rgb[(greatest + 2) % 3] = yRatio * value;
            const Triple xyz = xyzOf(rgb);
            p = (start ? fit.Fit(xyz, *start) : fit.Fit(xyz)).parameters;
        }
        const double scale = StoredScale(float(mean));
        nodes[Index(greatest, y, x, z)] =
            Lanes{float(p[0] * scale), float(p[1] * scale), float(p[2] * scale), 0};
        return p;
    };
    constexpr int Middle = ZCount / 2;
    const SigmoidParameters middle = fill(Middle, nullptr);
    SigmoidParameters p = middle;
    for (int z = Middle + 1; z < ZCount; ++z)
        p = fill(z, &p);
    p = middle;
    for (int z = Middle - 1; z >= 0; --z)
        p = fill(z, &p);
}

SigmoidTable::Lanes SigmoidTable::Interpolate(const std::array<float, 3> &rgb) const {
    const int greatest = rgb[0] > rgb[1] ? (rgb[0] > rgb[2] ? 0 : 2) : (rgb[1] > rgb[2] ? 1 : 2);
    const float z = rgb[greatest];
    const Cell cz = CellAt(PositionOfGreatest(z), ZCount);
    const Cell cx = CellAt(PositionOfRatio(rgb[(greatest + 1) % 3] / z), XYCount);
    const Cell cy = CellAt(PositionOfRatio(rgb[(greatest + 2) % 3] / z), XYCount);
    const Lanes *corner = &nodes[Index(greatest, cy.index, cx.index, cz.index)];
    const auto along = [](float t, Lanes a, Lanes b) { return a + t * (b - a); };
    const auto edge = [&](size_t offset) {
        return along(cz.fraction, corner[offset], corner[offset + 1]);
    };
    constexpr size_t stepX = ZCount, stepY = XYCount * ZCount;
    return along(cy.fraction, along(cx.fraction, edge(0), edge(stepX)),
                 along(cx.fraction, edge(stepY), edge(stepX + stepY)));
}

RGBSigmoid SigmoidTable::LookUp(const std::array<float, 3> &rgb) const {
    const float mean = (rgb[0] + rgb[1] + rgb[2]) / 3;
    Lanes p = mean > 0.5f ? -Interpolate({1 - rgb[0], 1 - rgb[1], 1 - rgb[2]}) : Interpolate(rgb);
    p /= StoredScale(mean);
    return ToSigmoid({p[0], p[1], p[2]});
}

}  // namespace pbrt
