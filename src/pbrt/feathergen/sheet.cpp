#include "pbrt/feathergen/sheet.h"

#include <algorithm>

namespace pbrt::feathergen {
namespace {

constexpr int kSteps = 32;       ///< along a barb
constexpr double kSeen = 0.5;    ///< part of the rachis that others hide
constexpr double kStiff = 0.55;  ///< part of a barb that does not give way

}  // namespace

Sheet::Sheet(const Feather &feather) : length(feather.parameters.rachisLength) {
    Vec3d low{1e30, 1e30, 0}, high{-1e30, -1e30, 0};
    std::vector<Vec3d> all;
    for (size_t b = 0; b < feather.barbs.size(); ++b)
        for (int i = 0; i <= kSteps * kStiff; ++i) {
            const Vec3d p = feather.barbs[b].axis.Point(double(i) / kSteps);
            all.push_back(p);
            low = Min(low, p), high = Max(high, p);
            if (b % 4 < 2 && i % 8 == 0 && p.y > kSeen * length) points.push_back(p);
        }
    for (int i = 0; i <= 8; ++i) {
        spine.push_back(feather.rachis.Point(Lerp(i / 8.0, kSeen, 1.0)));
        points.push_back(spine.back());
    }
    // Fine enough for single barbs, within reason.
    constexpr double kMostCells = 400;
    const double extent = std::max(high.x - low.x, high.y - low.y);
    cell = std::max(0.7 * feather.parameters.barbWidth, extent / kMostCells);
    x0 = low.x - cell, y0 = low.y - cell;
    columns = int((high.x - x0) / cell) + 2, rows = int((high.y - y0) / cell) + 2;
    heights.assign(size_t(columns) * size_t(rows), kEmpty);
    for (const Vec3d &p : all)
        Splat(p);
}

void Sheet::Splat(Vec3d p) {
    const int column = int((p.x - x0) / cell), row = int((p.y - y0) / cell);
    for (int j = std::max(0, row - 1); j <= std::min(rows - 1, row + 1); ++j)
        for (int i = std::max(0, column - 1); i <= std::min(columns - 1, column + 1); ++i) {
            double &height = heights[CellIndex(i, j)];
            height = std::max(height, p.z);
        }
}

std::optional<double> Sheet::Height(double x, double y) const {
    const double column = std::floor((x - x0) / cell), row = std::floor((y - y0) / cell);
    if (!(column >= 0 && row >= 0 && column < columns && row < rows)) return {};
    const double height = heights[CellIndex(int(column), int(row))];
    if (height == kEmpty) return {};
    return height;
}

}  // namespace pbrt::feathergen
