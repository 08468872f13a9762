#pragma once

#include <array>
#include <vector>

#include "pbrt/scene/params.h"
#include "pbrt/spectra/color.h"
#include "pbrt/spectra/sampled_spectrum.h"

namespace pbrt {

/// From spectral radiance to the film's RGB: the CIE 1931 observer or a camera's curves
/// (camera_curves.h), white balance, exposure and the limit `maxcomponentvalue`, which is that of
/// what the sensor sees.
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
    /// RGB of a reflectance under the film's white, neither exposed nor clamped: 1 for 1 (about 1
    /// where a camera sees it).
    RGB ColorOf(SampledSpectrum reflectance, const SampledWavelengths &lambda) const;

  private:
    /// Mean over the wavelengths of L times `matching` over the pdf.
    FloatX4 Matched(SampledSpectrum L, const SampledWavelengths &lambda) const;
    RGB ToFilm(FloatX4 seen) const;
    void SetResponse(const std::array<Spectrum, 3> &curves, const Matrix3 &xyzFromSensor,
                     const RGBColorSpace &space);

    float iso = 100, imagingRatio = 1, maxComponentValue = Infinity;
    bool isLimited = false;  ///< maxComponentValue is finite
    Matrix3 rgbFromSensor{};
    /// Per whole nm from 360: the film's r, g, b matching curves (the fourth is padding), where
    /// isLimited the sensor's own, over the number of wavelengths.
    std::vector<std::array<float, 4>> matching;
    Spectrum white;  ///< of luminance 1
};

}  // namespace pbrt
