#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/util/math.h"
#include "support/quadrature.h"

namespace pbrt::test {

/// Bins of equal steps in polar angle and azimuth over the whole sphere.
struct SphereBins {
    static constexpr int kRows = 80, kColumns = 160, kCount = kRows * kColumns;
    static constexpr int kDepthAtPeaks = 6;  ///< beyond that of all others

    struct Angles {
        double phi, theta;  ///< phi in [0, 2 pi)
    };
    static Angles AnglesOf(Vector3f w) {
        const float phi = std::atan2(w.y, w.x);
        return {phi < 0 ? phi + 2 * M_PI : phi, std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z)};
    }
    static int IndexOf(Vector3f w) {
        const Angles a = AnglesOf(w);
        const int row = std::min(kRows - 1, int(a.theta / M_PI * kRows));
        return row * kColumns + int(a.phi / (2 * M_PI) * kColumns) % kColumns;
    }
    /// The integral of a density per unit solid angle over each bin; `tolerance` for each.
    /// A lobe's edge that only cuts a bin's corner may escape the points taken there, so bins
    /// much unlike one of their neighbours are integrated again, in sixteen parts; and the bins
    /// about the directions `peaks`, where the density may even be infinite, in ever smaller parts.
    template <typename F>
    static std::vector<double> Integrate(const F &density, double tolerance,
                                         const std::vector<Vector3f> &peaks = {}) {
        const auto perAngles = [&](double phi, double theta) {
            const SinCos t = SinCosTurns(float(theta / (2 * M_PI)));
            const SinCos p = SinCosTurns(float(phi / (2 * M_PI)));
            return t.sin * density(Vector3f{t.sin * p.cos, t.sin * p.sin, t.cos});
        };
        std::vector<Angles> corners;
        for (const Vector3f &w : peaks)
            corners.push_back(AnglesOf(w));
        const auto integrate = [&](int i, int parts) {
            const double dTheta = M_PI / kRows, dPhi = 2 * M_PI / kColumns;
            const int row = i / kColumns, column = i % kColumns;
            double sum = 0;
            for (int k = 0; k < parts * parts; ++k) {
                const double x = dPhi * (column + double(k % parts) / parts);
                const double y = dTheta * (row + double(k / parts) / parts);
                sum += IntegrateBox(perAngles, {x, x + dPhi / parts, y, y + dTheta / parts},
                                    tolerance / parts, 6, corners);
            }
            return sum;
        };
        std::vector<double> first, bins;
        for (int i = 0; i < kCount; ++i)
            first.push_back(integrate(i, 1));
        for (int i = 0; i < kCount; ++i) {
            const auto [least, most] = Neighbourhood(first, i);
            const bool isPlain = most <= 4 * least + 20 * tolerance;
            bins.push_back(isPlain ? first[size_t(i)] : integrate(i, 4));
        }
        return bins;
    }
    /// The least and the most in a bin and its eight neighbours.
    static std::pair<double, double> Neighbourhood(const std::vector<double> &bins, int i) {
        std::pair range{bins[size_t(i)], bins[size_t(i)]};
        for (int dr : {-1, 0, 1}) {
            for (int dc : {-1, 0, 1}) {
                const int row = std::clamp(i / kColumns + dr, 0, kRows - 1);
                const int column = (i + dc + kColumns) % kColumns;
                const double bin = bins[size_t(row * kColumns + column)];
                range = {std::min(range.first, bin), std::max(range.second, bin)};
            }
        }
        return range;
    }
    /// As IntegrateAdaptively, but against Simpson's rule, which looks at the edges: densities jump
    /// along lines of equal polar angle, and no midpoint sees a jump near the edge of a bin.
    template <typename F>
    static double IntegrateBox(const F &f, const Box &b, double tolerance, int depth,
                               const std::vector<Angles> &peaks) {
        const double w = b.x1 - b.x0, h = b.y1 - b.y0;
        double simpson = 0;
        for (int k = 0; k < 9; ++k) {
            const int i = k % 3, j = k / 3;
            simpson += (i == 1 ? 4 : 1) * (j == 1 ? 4 : 1) * f(b.x0 + w * i / 2, b.y0 + h * j / 2);
        }
        simpson *= w * h / 36;
        const double fine = detail::Midpoints(f, b, 8);
        const bool holdsPeak = std::any_of(peaks.begin(), peaks.end(), [&b](Angles p) {
            return p.phi >= b.x0 && p.phi <= b.x1 && p.theta >= b.y0 && p.theta <= b.y1;
        });
        const bool isDone = depth <= 0 || std::abs(fine - simpson) <= tolerance;
        if (holdsPeak ? depth <= -kDepthAtPeaks : isDone) return fine;
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            const double x = b.x0 + w / 2 * (k % 2), y = b.y0 + h / 2 * (k / 2);
            sum += IntegrateBox(f, {x, x + w / 2, y, y + h / 2}, tolerance / 2, depth - 1, peaks);
        }
        return sum;
    }
    /// Writes layers of bins as the channels of one picture, rows from +z down.
    static void Dump(const std::string &fileName, const std::vector<std::string> &names,
                     const std::vector<const std::vector<double> *> &layers) {
        Image image({kColumns, kRows}, names);
        for (int i = 0; i < kCount; ++i) {
            for (size_t c = 0; c < layers.size(); ++c)
                image.Set({i % kColumns, i / kColumns}, int(c), float((*layers[c])[size_t(i)]));
        }
        WriteImage(image, fileName, ExrPixels::Float);
    }
};

}  // namespace pbrt::test
