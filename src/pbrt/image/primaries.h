#pragma once

#include <array>
#include <optional>

namespace pbrt {

using Chromaticities = std::array<std::array<float, 2>, 4>;  ///< xy: R G B white

inline constexpr Chromaticities kSRGBChromaticities{
    {{0.64f, 0.33f}, {0.3f, 0.6f}, {0.15f, 0.06f}, {0.3127f, 0.329f}}};

/// Within 1e-4 in each coordinate.
bool SamePrimaries(const Chromaticities &a, const Chromaticities &b);

/// Matrix [row][column] that turns linear RGB of the primaries `from` into that of `to`, through
/// XYZ and without adaptation of the white (as pbrt-v4 converts). nullopt where a set of primaries
/// spans no space: three on a line, or a white of y = 0.
std::optional<std::array<std::array<float, 3>, 3>> RGBFromRGB(const Chromaticities &to,
                                                              const Chromaticities &from);

}  // namespace pbrt
