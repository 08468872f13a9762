#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/complex_airy.h"

namespace pbrt::oracle {

/// A film whose thickness has a normal distribution about film.thickness.
struct RoughFilm {
    AiryFilm film;
    double deviation;  ///< its standard deviation, > 0, in the film's unit of length
};

/// Power that passes, averaged over the thickness: the trapezoidal rule over nine deviations on
/// either side, whose error falls exponentially with the step. Below a thickness of 0 the formulas
/// go on, as an even function.
inline double MeanTransmittance(const RoughFilm &rough, double cosine, Polarisation p) {
    // A fringe of a keratin film at 85 degrees is a few nanometres wide for visible light.
    const double step = std::min(rough.deviation / 8, rough.film.lambda / 2000);
    const int half = int(std::ceil(9 * rough.deviation / step));
    double sum = 0, weights = 0;
    for (int i = -half; i <= half; ++i) {
        const double x = i * step, weight = std::exp(-0.5 * std::pow(x / rough.deviation, 2));
        AiryFilm film = rough.film;
        film.thickness += x;
        sum += weight * std::norm(AirySum(film, cosine, p).t);
        weights += weight;
    }
    return sum / weights;
}

/// The same of the power reflected, without polarisation.
inline double MeanReflectance(const RoughFilm &rough, double cosine) {
    return 1 - (MeanTransmittance(rough, cosine, Polarisation::S) +
                MeanTransmittance(rough, cosine, Polarisation::P)) /
                   2;
}

/// Transmittance of a film whose sin^2 of the phase is its mean over the thickness, from Fresnel's
/// reflectance F of one surface: 1/T = 1 + 4 F / (1 - F)^2 sin^2.
inline double TransmittanceOfMeanSine(const RoughFilm &rough, double cosine, Polarisation p) {
    const AiryFilm &f = rough.film;
    const double inside = CosineInside(f.index, cosine);
    const double F = std::pow(Fresnel(p, 1, cosine, f.index, inside).r, 2);
    const double k = 2 * std::numbers::pi * f.index * inside / f.lambda;
    const double kept = std::exp(-2 * std::pow(k * rough.deviation, 2));
    const double sine = (1 - kept * std::cos(2 * k * f.thickness)) / 2;
    return 1 / (1 + 4 * F / std::pow(1 - F, 2) * sine);
}

}  // namespace pbrt::oracle
