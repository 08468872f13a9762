#pragma once

#include <span>
#include <vector>

#include "pbrt/spectra/color.h"

namespace pbrt::bsdftool {

/// Turns reflectances at equally spaced wavelengths into colors under an illuminant: CIE XYZ with
/// Y = 1 for what reflects everything, and linear sRGB from it. Nothing is adapted to the white of
/// sRGB, so a white surface under equal energy is slightly pink, as in an image of pbrt's.
class Observer {
  public:
    /// At least two wavelengths; sums are as exact as their distance lets them be.
    Observer(const std::vector<float> &lambda, const Spectrum &illuminant);

    /// One value per wavelength.
    XYZ ToXYZ(std::span<const float> values) const;
    RGB ToRGB(std::span<const float> values) const {
        return RGBColorSpace::sRGB().ToRGB(ToXYZ(values));
    }

  private:
    std::vector<XYZ> weights;
};

}  // namespace pbrt::bsdftool
