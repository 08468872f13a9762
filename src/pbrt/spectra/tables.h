#pragma once

#include <array>

/// Measured data behind the named spectra; sources stand beside the numbers.
namespace pbrt::spectra::tables {

extern const std::array<float, 471> cieX, cieY, cieZ;
extern const std::array<float, 54> daylight0, daylight1, daylight2;
extern const std::array<std::array<float, 81>, 12> fluorescent;
extern const std::array<float, 41> metalAgLambda, metalAgEta, metalAgK;
extern const std::array<float, 41> metalAlLambda, metalAlEta, metalAlK;
extern const std::array<float, 41> metalAuLambda, metalAuEta, metalAuK;
extern const std::array<float, 41> metalCuLambda, metalCuEta, metalCuK;
extern const std::array<float, 48> metalCuZnLambda, metalCuZnEta, metalCuZnK;
extern const std::array<float, 27> metalTiO2Lambda, metalTiO2Eta, metalTiO2K;

}  // namespace pbrt::spectra::tables
