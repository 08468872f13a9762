#pragma once

#include <array>
#include <vector>

#include "pbrt/scene/params.h"
#include "pbrt/spectra/color.h"
#include "pbrt/spectra/sampled_spectrum.h"

namespace pbrt {

/// From spectral radiance to the film's RGB: the CIE 1931 observer, white balance, exposure and the
/// limit `maxcomponentvalue`.
class Sensor {
  public:
    static Sensor Create(ParamDict &params, const RGBColorSpace &space);
    /// Shutter time in seconds: the imaging ratio is seconds * iso / 100.
    void SetExposure(float seconds) { imagingRatio = seconds * iso / 100; }

    /// RGB of the radiance L sampled at lambda: mean over the wavelengths of L times the matching
    /// curves over the pdf, exposed and clamped. Wavelengths of pdf 0 (terminated) do not count.
    RGB Response(SampledSpectrum L, const SampledWavelengths &lambda) const;
    /// L wavelength by wavelength, exposed and clamped; under a light of constant spectrum 1 it is
    /// 1 where Response has a Y of 1.
    SampledSpectrum Exposed(SampledSpectrum L) const;
    /// RGB of a reflectance under the film's white, neither exposed nor clamped: 1 for 1.
    RGB ColorOf(SampledSpectrum reflectance, const SampledWavelengths &lambda) const;

  private:
    FloatX4 Matched(SampledSpectrum L, const SampledWavelengths &lambda) const;

    float iso = 100, imagingRatio = 1, maxComponentValue = Infinity;
    /// Per whole nm from 360: the film's r, g, b matching curves (the fourth is padding) over the
    /// number of wavelengths.
    std::vector<std::array<float, 4>> matching;
    Spectrum white;  ///< of luminance 1
};

}  // namespace pbrt
