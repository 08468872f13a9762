#pragma once

#include <memory>

#include "pbrt/scene/params.h"

namespace pbrt {

/// A light's spectrum in the renderer's units: one unit of RGB is a CIE-Y integral of 1, so that it
/// renders as pixel value 1 (PBRT_FORMAT 2.10).
struct Emission {
    std::shared_ptr<const Spectrum> spectrum;
    float luminance = 0;  ///< its CIE-Y integral
};

/// Parameters that lights share. `power` and `illuminance`: not above 0, as scale alone says.
inline constexpr SpectrumParam kLightIntensity{
    "I", SpectrumType::Illuminant, "the color space's white", "spectrum of the intensity"};
inline constexpr SpectrumParam kLightRadiance{
    "L", SpectrumType::Illuminant, "the color space's white", "spectrum of the radiance"};
inline constexpr FloatParam kLightPower{
    "power", "lm",  -1,
    -1,      kOpen, "luminous flux to emit; not above 0: as the spectrum and scale say"};
inline constexpr FloatParam kLightIlluminance{
    "illuminance",
    "lx",
    -1,
    -1,
    kOpen,
    "of a surface that faces the light; not above 0: as the spectrum and scale say"};

/// The spectrum of `row` (default: the colour space's illuminant), as a table but for `rgb`,
/// divided by the CIE-Y integral: of the illuminant for `rgb`, else of the spectrum itself. A
/// spectrum without visible light is an error; the default is returned then.
Emission GetEmission(ParamDict &params, const SpectrumParam &row);

/// `scale`, and the flux or illuminance that is asked for; not above 0: as `scale` alone says.
struct EmissionScale {
    float scale = 1, target = -1;
    /// Factor for a light that gives `amount` > 0 of what is asked for at factor 1.
    float For(float amount) const { return target > 0 ? scale * target / amount : scale; }
};
/// Reads `scale` and `target`, which is kLightPower or kLightIlluminance.
EmissionScale GetScale(ParamDict &params, const FloatParam &target);

}  // namespace pbrt
