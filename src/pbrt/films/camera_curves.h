#pragma once

#include <array>
#include <span>
#include <string_view>

namespace pbrt {

/// Relative response of a camera's red, green and blue pixels to spectral radiance, at 380, 385,
/// ... 780 nm; 0 elsewhere.
struct CameraCurves {
    std::string_view name;  ///< as in `"string sensor"`
    std::array<std::array<float, 81>, 3> rgb;

    static constexpr float kFirst = 380, kStep = 5;
};
/// Those of pbrt-v4's names (PBRT_FORMAT 2.1).
std::span<const CameraCurves> AllCameraCurves();

/// Reflectances of the 24 patches of a color checker chart at 380, 390, ... 730 nm.
struct ColorCheckerPatch {
    std::array<float, 36> reflectance;

    static constexpr float kFirst = 380, kStep = 10;
};
std::span<const ColorCheckerPatch> ColorChecker();

}  // namespace pbrt
