#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// A rectangle in the unit square, min <= max.
struct Window {
    Point2f min, max;
};

/// A density over the unit square, constant in each of n x n cells, that can be drawn from within
/// any window, exactly: sums over rectangles of cells stand in a table (Bitterli, Novak, Jarosz
/// 2015, "Portal-Masked Environment Map Sampling").
class WindowedDistribution {
  public:
    struct Sample {
        Point2f p;
        float pdf;  ///< per area of the square
    };

    WindowedDistribution() = default;
    /// Weights of the cells, none negative, row by row.
    WindowedDistribution(std::vector<float> weights, int n)
        : n(n), weights(std::move(weights)), sums(size_t(n + 1) * size_t(n + 1)) {
        for (int y = 0; y < n; ++y) {
            double row = 0;
            for (int x = 0; x < n; ++x) {
                row += double(Weight(x, y));
                sums[Index(x + 1, y + 1)] = sums[Index(x + 1, y)] + row;
            }
        }
    }

    /// nullopt where the window's weights are 0.
    std::optional<Sample> Draw(Point2f u, const Window &window) const {
        const Range x = InCells(window.min.x, window.max.x),
                    y = InCells(window.min.y, window.max.y);
        const double total = Sum(x, y);
        if (!(total > 0)) return std::nullopt;
        const auto upTo = [&](double end) { return Sum({x.lo, end}, y); };
        const double px = Where(upTo, double(u.x) * total, x);
        const double column = std::min(std::floor(px), double(n - 1));
        const Range own{column, column + 1};
        const auto ownUpTo = [&](double end) { return Sum(own, {y.lo, end}); };
        const double py = Where(ownUpTo, double(u.y) * Sum(own, y), y);
        const int row = std::min(int(py), n - 1);
        const double pdf = double(Weight(int(column), row)) * n * n / total;
        if (!(pdf > 0)) return std::nullopt;
        return Sample{{float(px / n), float(py / n)}, float(pdf)};
    }
    /// Density of Draw at p; 0 outside the window.
    float PDF(Point2f p, const Window &window) const {
        if (!(p.x >= window.min.x && p.x <= window.max.x && p.y >= window.min.y &&
              p.y <= window.max.y))
            return 0;
        const double total =
            Sum(InCells(window.min.x, window.max.x), InCells(window.min.y, window.max.y));
        const auto cell = [&](float x) { return std::clamp(int(x * float(n)), 0, n - 1); };
        return total > 0 ? float(double(Weight(cell(p.x), cell(p.y))) * n * n / total) : 0;
    }

  private:
    /// From lo to hi, in cells.
    struct Range {
        double lo, hi;
    };
    Range InCells(float lo, float hi) const {
        const auto at = [&](float x) { return std::clamp(double(x) * n, 0., double(n)); };
        return {at(lo), at(hi)};
    }
    float Weight(int x, int y) const { return weights[size_t(y) * size_t(n) + size_t(x)]; }
    size_t Index(int x, int y) const { return size_t(y) * size_t(n + 1) + size_t(x); }

    /// Sum of all weights before x and y; bilinear within cells, as their weights are constant.
    double Before(double x, double y) const {
        const int i = std::min(int(x), n - 1), j = std::min(int(y), n - 1);
        const double s = x - i, t = y - j;
        return (1 - t) * ((1 - s) * sums[Index(i, j)] + s * sums[Index(i + 1, j)]) +
               t * ((1 - s) * sums[Index(i, j + 1)] + s * sums[Index(i + 1, j + 1)]);
    }
    double Sum(Range x, Range y) const {
        return std::max(
            0., Before(x.hi, y.hi) - Before(x.lo, y.hi) - Before(x.hi, y.lo) + Before(x.lo, y.lo));
    }

    /// The place in the range up to which the increasing function, linear within each cell, has
    /// grown to `target`.
    template <typename F>
    static double Where(const F &grown, double target, Range range) {
        // The cell, by halving among those that the range meets.
        int lo = int(range.lo), hi = std::max(lo + 1, int(std::ceil(range.hi)));
        while (hi - lo > 1) {
            const int middle = lo + (hi - lo) / 2;
            (grown(std::min(double(middle), range.hi)) <= target ? lo : hi) = middle;
        }
        const double a = std::max(double(lo), range.lo), b = std::min(double(lo + 1), range.hi);
        const double before = grown(a), within = grown(b) - before;
        return within > 0 ? std::clamp(a + (b - a) * (target - before) / within, a, b) : a;
    }

    int n = 0;
    std::vector<float> weights;
    std::vector<double> sums;  ///< of the cells left of and above each corner
};

}  // namespace pbrt
