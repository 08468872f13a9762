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

    static int IndexOf(Vector3f w) {
        const float theta = std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
        const float phi = std::atan2(w.y, w.x);
        const int row = std::min(kRows - 1, int(theta * InvPi * kRows));
        const int column = int((phi * InvPi / 2 + 1) * kColumns) % kColumns;
        return row * kColumns + column;
    }
    /// The integral of a density per unit solid angle over each bin; `tolerance` for each.
    template <typename F>
    static std::vector<double> Integrate(const F &density, double tolerance) {
        const auto perAngles = [&](double phi, double theta) {
            const SinCos t = SinCosTurns(float(theta / (2 * M_PI)));
            const SinCos p = SinCosTurns(float(phi / (2 * M_PI)));
            return t.sin * density(Vector3f{t.sin * p.cos, t.sin * p.sin, t.cos});
        };
        const double dTheta = M_PI / kRows, dPhi = 2 * M_PI / kColumns;
        std::vector<double> bins;
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column)
                bins.push_back(IntegrateBox(
                    perAngles,
                    {column * dPhi, (column + 1) * dPhi, row * dTheta, (row + 1) * dTheta},
                    tolerance, 6));
        }
        return bins;
    }
    /// As IntegrateAdaptively, but against Simpson's rule, which looks at the edges: densities jump
    /// along lines of equal polar angle, and no midpoint sees a jump near the edge of a bin.
    template <typename F>
    static double IntegrateBox(const F &f, const Box &b, double tolerance, int depth) {
        const double w = b.x1 - b.x0, h = b.y1 - b.y0;
        double simpson = 0;
        for (int k = 0; k < 9; ++k) {
            const int i = k % 3, j = k / 3;
            simpson += (i == 1 ? 4 : 1) * (j == 1 ? 4 : 1) * f(b.x0 + w * i / 2, b.y0 + h * j / 2);
        }
        simpson *= w * h / 36;
        const double fine = detail::Midpoints(f, b, 8);
        if (depth == 0 || std::abs(fine - simpson) <= tolerance) return fine;
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            const double x = b.x0 + w / 2 * (k % 2), y = b.y0 + h / 2 * (k / 2);
            sum += IntegrateBox(f, {x, x + w / 2, y, y + h / 2}, tolerance / 2, depth - 1);
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
