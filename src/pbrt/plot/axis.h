#pragma once

#include <vector>

namespace pbrt::plot {

/// A range of values along a line of pixels.
struct Axis {
    double lo, hi;      ///< values
    double start, end;  ///< their pixels

    double At(double value) const { return start + (end - start) * (value - lo) / (hi - lo); }
    /// Round numbers within [lo, hi], about `count` of them.
    std::vector<double> Ticks(int count) const;
};

}  // namespace pbrt::plot
