#pragma once

#include <vector>

#include "pbrt/util/math.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Functions whose integral is 0.
inline double Smooth(Point2f p) {
    return p.x * p.y * p.y - 1.0 / 6;
}
inline double Edge(Point2f p) {
    return (p.x * p.x + p.y * p.y < 0.5f ? 1 : 0) - 3.14159265358979 / 8;
}

/// Each pixel's mean of f, whose integral is 0, over its samples; `draw` draws one.
template <typename S, typename Draw, typename F>
std::vector<double> Errors(S sampler, int side, int dimension, const F &f, const Draw &draw) {
    std::vector<double> errors;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            double sum = 0;
            for (int i = 0; i < sampler.SamplesPerPixel(); ++i) {
                sampler.StartPixelSample({x, y}, i, dimension);
                sum += f(draw(sampler));
            }
            errors.push_back(sum / sampler.SamplesPerPixel());
        }
    }
    return errors;
}
template <typename S>
std::vector<double> Errors(S sampler, int side, int dimension, double (*f)(Point2f)) {
    return Errors(sampler, side, dimension, f, [](S &s) { return s.Get2D(); });
}
template <typename S, typename F>
std::vector<double> SingleErrors(S sampler, int side, int dimension, const F &f) {
    return Errors(sampler, side, dimension, f, [](S &s) { return s.Get1D(); });
}

/// Variance of the means of blocks of 4 x 4 pixels, relative to what errors without correlation
/// would have: 1 is white noise, 0 has no low frequencies.
inline double LowFrequencies(const std::vector<double> &errors, int side, Point2i shift) {
    double blocks = 0, pixels = 0;
    int nBlocks = 0;
    for (int by = shift.y; by + 4 <= side; by += 4) {
        for (int bx = shift.x; bx + 4 <= side; bx += 4, ++nBlocks) {
            double sum = 0;
            for (int k = 0; k < 16; ++k)
                sum += errors[size_t((by + k / 4) * side + bx + k % 4)];
            blocks += Sqr(sum / 16);
        }
    }
    for (double e : errors)
        pixels += e * e;
    return blocks / nBlocks / (pixels / double(errors.size())) * 16;
}

}  // namespace pbrt
