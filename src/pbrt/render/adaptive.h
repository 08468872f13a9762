#pragma once

#include <span>

#include "pbrt/films/film.h"

namespace pbrt {

/// The least samples of a pixel before its error is judged. Fewer miss rare bright paths: tiles
/// stop that have not seen them.
inline constexpr int kFirstJudgement = 16;

/// Estimate of the relative squared error of some pixels' means, from how much the means of their
/// first samples and of the rest differ: of a mean x and its error e the mean of e^2 / (x^2 + 0.01)
/// over pixels and channels. Right for independent samples; for those of a low-discrepancy sampler,
/// whose parts complete each other, too large.
double RelativeSquaredError(std::span<const Film::Pixel> first, std::span<const Film::Pixel> all);

}  // namespace pbrt
