#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "pbrt/feather/direction.h"

namespace pbrt::feather {

/// rms errors of TRT over pairs of directions, relative to its mean: of the light in it (times both
/// cosines, what a picture sees), and of f.
struct TRTError {
    double light, f;
};

/// Sums errors up, pair by pair.
class TRTErrorSum {
  public:
    /// Values per wavelength, as many of either as `exact` has.
    template <class Found, class Exact>
    void Add(const Direction<double> &wo, const Direction<double> &wi, const Found &found,
             const Exact &exact) {
        const double cosines = wo.z * wi.z;
        for (std::size_t k = 0; k < exact.size(); ++k) {
            const double off = found[k] - exact[k];
            squares.f += off * off;
            squares.light += off * off * cosines * cosines;
            sum.f += exact[k];
            sum.light += exact[k] * cosines;
        }
        count += double(exact.size());
    }
    /// Nothing where TRT is 0 everywhere.
    std::optional<TRTError> Relative() const {
        if (sum.f == 0) return std::nullopt;
        return TRTError{std::sqrt(squares.light / count) / (sum.light / count),
                        std::sqrt(squares.f / count) / (sum.f / count)};
    }

  private:
    TRTError squares{}, sum{};
    double count = 0;
};

}  // namespace pbrt::feather
