#pragma once

#include <array>
#include <vector>

#include "pbrt/spectra/spectrum.h"

namespace pbrt {

using Triple = std::array<double, 3>;

/// x(t) = (p[0] t + p[1]) t + p[2] with t = (lambda - 595 nm) / 235 nm, in [-1, 1]: the quadratic
/// inside RGBSigmoid, better conditioned.
using SigmoidParameters = Triple;
RGBSigmoid ToSigmoid(const SigmoidParameters &p);

/// Finds sigmoids of given colours under one illuminant.
///
/// Sigmoids with finite parameters reach every colour strictly inside the object-colour solid
/// (all reflectances within [0, 1]), each once: their limits are the optimal colours, which
/// bound it. Newton's method on CIELAB differences therefore converges to the colour, or where
/// that is out of reach to a colour of small difference.
class SigmoidFit {
  public:
    explicit SigmoidFit(const Spectrum &illuminant);

    /// XYZ of the illuminant; Y is 1.
    const Triple &White() const { return white; }

    struct Result {
        SigmoidParameters parameters;
        double difference;  ///< CIELAB (1976) difference that remains
    };
    /// Sigmoid of the colour `xyz`. `start`: parameters of a colour near it.
    Result Fit(const Triple &xyz, const SigmoidParameters &start) const;
    /// The same from nothing: by way of greys.
    Result Fit(const Triple &xyz) const;
    /// XYZ of the sigmoid.
    Triple Color(const SigmoidParameters &p) const;

  private:
    struct Trial;
    std::array<std::array<double, 4>, 3> Moments(const SigmoidParameters &p) const;
    Trial Try(const SigmoidParameters &p, const Triple &targetLab) const;
    Triple Lab(const Triple &xyz) const;

    using Lanes = double __attribute__((vector_size(32)));
    static constexpr int Blocks = 118;         ///< 471 wavelengths and one of weight 0, by fours
    std::vector<Lanes> position;               ///< t of each wavelength
    std::array<std::vector<Lanes>, 3> weight;  ///< illuminant times matching functions
    Triple white{};
};

}  // namespace pbrt
