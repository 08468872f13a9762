#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/util/vecmath.h"
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
    static std::vector<double> Integrate(const std::function<double(Vector3f)> &density,
                                         double tolerance) {
        const auto perAngles = [&](double phi, double theta) {
            const double s = std::sin(theta);
            return s * density({float(s * std::cos(phi)), float(s * std::sin(phi)),
                                float(std::cos(theta))});
        };
        const double dTheta = M_PI / kRows, dPhi = 2 * M_PI / kColumns;
        std::vector<double> bins;
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column)
                bins.push_back(IntegrateAdaptively(
                    perAngles,
                    {column * dPhi, (column + 1) * dPhi, row * dTheta, (row + 1) * dTheta},
                    tolerance, 6));
        }
        return bins;
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
