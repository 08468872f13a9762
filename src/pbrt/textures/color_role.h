#pragma once

#include <algorithm>

#include "pbrt/scene/params.h"
#include "pbrt/spectra/color.h"

namespace pbrt {

// Values that are not below 0 as spectra by role; albedos above 1 count as 1.

inline SampledSpectrum SampleColor(const RGBColorSpace &space, RGB rgb, SpectrumType role,
                                   const SampledWavelengths &lambda) {
    if (role == SpectrumType::Unbounded) return space.SampleUnbounded(rgb, lambda);
    if (role == SpectrumType::Illuminant) return space.SampleIlluminant(rgb, lambda);
    rgb = {std::min(rgb.r, 1.f), std::min(rgb.g, 1.f), std::min(rgb.b, 1.f)};
    return space.SampleAlbedo(rgb, lambda);
}
/// SampleColor for three equal components, without its fit where the spectrum is flat.
inline SampledSpectrum SampleGrey(const RGBColorSpace &space, float v, SpectrumType role,
                                  const SampledWavelengths &lambda) {
    if (role == SpectrumType::Illuminant) return space.SampleIlluminant({v, v, v}, lambda);
    return SampledSpectrum(role == SpectrumType::Albedo ? std::min(v, 1.f) : v);
}

}  // namespace pbrt
