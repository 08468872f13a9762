#pragma once

#include "pbrt/spectra/color.h"
#include "pbrt/spectra/sampled_spectrum.h"
#include "pbrt/util/math.h"

namespace pbrt {

// Absorption of a fibre, per fibre radius, from what scenes may give instead of it.

/// Absorption of melanin: concentrations >= 0, each weighted with the absorption of its kind
/// (PBRT_FORMAT 2.8, hair), as unbounded sRGB.
inline RGB SigmaAFromConcentration(float eumelanin, float pheomelanin) {
    return RGB{0.419f, 0.697f, 1.37f} * eumelanin + RGB{0.187f, 0.4f, 1.05f} * pheomelanin;
}

/// Absorption of fibres that make a mass of hair of the given colour, components clamped to
/// [1e-6, 1]: 0 would need infinite absorption, and what is left at 1e-6 is 2e-5 of the light.
/// Chiang et al. 2016, eq. 9; beta_n as in HairBxDF.
inline SampledSpectrum SigmaAFromReflectance(SampledSpectrum reflectance, float beta_n) {
    const float scale =
        EvaluatePolynomial(beta_n, 5.969f, -0.215f, 2.532f, -10.73f, 5.574f, 0.245f);
    SampledSpectrum sigma_a;
    for (int i = 0; i < NSpectrumSamples; ++i)
        sigma_a.Set(i, Sqr(std::log(std::clamp(reflectance[i], 1e-6f, 1.f)) / scale));
    return sigma_a;
}

}  // namespace pbrt
