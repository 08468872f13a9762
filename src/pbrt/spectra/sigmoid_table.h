#pragma once

#include <array>
#include <span>
#include <vector>

#include "pbrt/spectra/sigmoid_fit.h"

namespace pbrt {

/// Sigmoids of the colours of an RGB space, tabulated.
///
/// Colours are addressed by which component is greatest, its value z and the two others relative
/// to it. Two facts keep the table small: the complement 1 - s of a sigmoid has the negated
/// parameters, so the brighter half of the cube (mean above 1/2) mirrors the darker; and
/// parameters grow like 1 / sqrt(mean) towards black, so they are stored times
/// 2 sqrt(mean (1 - mean)), a product that stays finite and is exact for greys.
/// Component error of a look-up in sRGB: 2e-3 at most, 2e-4 on average.
class SigmoidTable {
  public:
    /// Runs in parallel.
    explicit SigmoidTable(const SigmoidFit &fit);

    /// Components in [0, 1], not all equal.
    RGBSigmoid LookUp(const std::array<float, 3> &rgb) const;

  private:
    static constexpr int ZCount = 48, XYCount = 24;

    static size_t Index(int greatest, int y, int x, int z) {
        return size_t(((greatest * XYCount + y) * XYCount + x) * ZCount + z);
    }
    /// Colours of one ratio of components.
    struct Column {
        int greatest;
        double xRatio, yRatio;
    };
    static void FillColumn(const SigmoidFit &fit, const Column &column, std::span<const double> z,
                           FloatX4 *out);
    FloatX4 Interpolate(const std::array<float, 3> &rgb) const;

    std::vector<FloatX4> nodes;  ///< scaled parameters; the last lane is idle
};

}  // namespace pbrt
