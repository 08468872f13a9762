#include "pbrt/spectra/sigmoid_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

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
/// Values in [0, 1] at `count` equidistant positions.
std::vector<double> NodesOf(float (*position)(float), int count) {
    std::vector<double> nodes(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) {
        double low = 0, high = 1;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = (low + high) / 2;
            (position(float(middle)) < i / (count - 1.0) ? low : high) = middle;
        }
        nodes[static_cast<size_t>(i)] = high;
    }
    nodes.back() = 1;
    return nodes;
}

float StoredScale(float mean) {
    return 2 * std::sqrt(mean * (1 - mean));
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

SigmoidTable::SigmoidTable(const SigmoidFit &fit) : nodes(Index(3, 0, 0, 0)) {
    std::vector<double> z = NodesOf(PositionOfGreatest, ZCount);
    z[0] = 1e-4;  // black has no sigmoid, but what is stored has a limit there
    const std::vector<double> ratio = NodesOf(PositionOfRatio, XYCount);
    tbb::parallel_for(0, 3 * XYCount * XYCount, [&](int i) {
        const int y = i / XYCount % XYCount, x = i % XYCount;
        // Mean of the least colour in the cells below the column's nodes, per z.
        const double least = (1 + (x ? ratio[x - 1] : 0) + (y ? ratio[y - 1] : 0)) / 3;
        const auto reached =
            std::find_if(z.begin(), z.end(), [&](double v) { return v * least > 0.5; });
        const size_t count = std::min(z.size(), size_t(reached - z.begin()) + 1);
        FillColumn(fit, {i / (XYCount * XYCount), ratio[x], ratio[y]}, {z.data(), count},
                   &nodes[Index(0, 0, 0, 0) + size_t(i) * ZCount]);
    });
}

void SigmoidTable::FillColumn(const SigmoidFit &fit, const Column &column,
                              std::span<const double> z, FloatX4 *out) {
    const double sum = 1 + column.xRatio + column.yRatio;
    const auto fill = [&](size_t i, const SigmoidParameters *start) {
        Triple rgb;
        rgb[column.greatest] = z[i];
        rgb[(column.greatest + 1) % 3] = column.xRatio * z[i];
        rgb[(column.greatest + 2) % 3] = column.yRatio * z[i];
        const SigmoidParameters p = (start ? fit.Fit(rgb, *start) : fit.Fit(rgb)).parameters;
        const double scale = StoredScale(float(z[i] * sum / 3));
        out[i] = FloatX4{float(p[0] * scale), float(p[1] * scale), float(p[2] * scale), 0};
        return p;
    };
    // Neighbours start from each other, from the easiest colours towards the extreme ones.
    const size_t middle = std::min(z.size() - 1, size_t(ZCount / 2));
    const SigmoidParameters first = fill(middle, nullptr);
    SigmoidParameters p = first;
    for (size_t i = middle + 1; i < z.size(); ++i)
        p = fill(i, &p);
    p = first;
    for (size_t i = middle; i-- > 0;)
        p = fill(i, &p);
}

FloatX4 SigmoidTable::Interpolate(const std::array<float, 3> &rgb) const {
    const int greatest = rgb[0] > rgb[1] ? (rgb[0] > rgb[2] ? 0 : 2) : (rgb[1] > rgb[2] ? 1 : 2);
    const float z = rgb[greatest];
    const Cell cz = CellAt(PositionOfGreatest(z), ZCount);
    const Cell cx = CellAt(PositionOfRatio(rgb[(greatest + 1) % 3] / z), XYCount);
    const Cell cy = CellAt(PositionOfRatio(rgb[(greatest + 2) % 3] / z), XYCount);
    const FloatX4 *corner = &nodes[Index(greatest, cy.index, cx.index, cz.index)];
    const auto along = [](float t, FloatX4 a, FloatX4 b) { return a + t * (b - a); };
    const auto edge = [&](size_t offset) {
        return along(cz.fraction, corner[offset], corner[offset + 1]);
    };
    constexpr size_t stepX = ZCount, stepY = XYCount * ZCount;
    return along(cy.fraction, along(cx.fraction, edge(0), edge(stepX)),
                 along(cx.fraction, edge(stepY), edge(stepX + stepY)));
}

RGBSigmoid SigmoidTable::LookUp(const std::array<float, 3> &rgb) const {
    const float mean = (rgb[0] + rgb[1] + rgb[2]) / 3;
    FloatX4 p = mean > 0.5f ? -Interpolate({1 - rgb[0], 1 - rgb[1], 1 - rgb[2]}) : Interpolate(rgb);
    p /= StoredScale(mean);
    return ToSigmoid({p[0], p[1], p[2]});
}

}  // namespace pbrt
