#pragma once

#include <array>
#include <vector>

#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/matrix.h"

namespace pbrt {

/// In double: a color, or the parameters of a sigmoid.
using Triple = std::array<double, 3>;

/// x(t) = (p[0] t + p[1]) t + p[2] with t = (lambda - 595 nm) / 235 nm, in [-1, 1]: the quadratic
/// inside RGBSigmoid, better conditioned.
using SigmoidParameters = Triple;
RGBSigmoid ToSigmoid(const SigmoidParameters &p);

/// Finds sigmoids of given colours under one illuminant.
///
/// Sigmoids with finite parameters reach every colour strictly inside the object-colour solid
/// (the colours of all reflectances within [0, 1]), each once: their limits are the optimal
/// colours, which bound it. Newton's method therefore converges to the colour, or where that is
/// out of reach to one whose RGB is near. (Differences in CIELAB would serve as well in sRGB, but
/// fail for primaries that no light has: they turn the blue of ACES2065-1 into black.)
class SigmoidFit {
  public:
    /// The illuminant's own colour is to be rgb 1 1 1 under `rgbFromXYZ`, XYZ having Y = 1 there.
    SigmoidFit(const Spectrum &illuminant, const Matrix3d &rgbFromXYZ);

    struct Result {
        SigmoidParameters parameters;
        double error;  ///< distance in RGB that remains
    };
    /// Sigmoid of `rgb`, components in [0, 1], neither black nor white.
    Result Fit(const Triple &rgb) const;
    /// The same from the parameters of a colour near it.
    Result Fit(const Triple &rgb, const SigmoidParameters &start) const;

  private:
    static constexpr int Blocks = 118;  ///< 471 wavelengths and one of weight 0, by fours
    struct Trial;
    Trial Try(const SigmoidParameters &p, const Triple &rgb) const;

    std::vector<DoubleX4> position;               ///< t of each wavelength
    std::array<std::vector<DoubleX4>, 3> weight;  ///< red, green, blue per unit of the spectrum
};

}  // namespace pbrt
