#pragma once

#include <cmath>

namespace pbrt::test {

/// A rectangle of the plane.
struct Box {
    double x0, x1, y0, y1;
};

namespace detail {

template <class F>
double Midpoints(const F &f, const Box &b, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += f(b.x0 + (b.x1 - b.x0) * (i + 0.5) / n, b.y0 + (b.y1 - b.y0) * (j + 0.5) / n);
    return sum * (b.x1 - b.x0) * (b.y1 - b.y0) / (n * n);
}

}  // namespace detail

/// The integral of a function with jumps over a box: midpoint rules, halved in both directions
/// until the estimate moves by less than `tolerance`, at most `depth` times. Features narrower than
/// a twentieth of the box may be missed.
template <class F>
double IntegrateAdaptively(const F &f, const Box &b, double tolerance, int depth = 12) {
    const double coarse = detail::Midpoints(f, b, 5), fine = detail::Midpoints(f, b, 14);
    if (depth == 0 || std::abs(fine - coarse) <= tolerance) return fine;
    const double x = (b.x0 + b.x1) / 2, y = (b.y0 + b.y1) / 2;
    double sum = 0;
    for (const Box &part : {Box{b.x0, x, b.y0, y}, Box{x, b.x1, b.y0, y}, Box{b.x0, x, y, b.y1},
                            Box{x, b.x1, y, b.y1}})
        sum += IntegrateAdaptively(f, part, tolerance / 2, depth - 1);
    return sum;
}

}  // namespace pbrt::test
