#pragma once

#include <array>

namespace pbrt::imgtool {

/// sRGB values in [0, 1] of the color map viridis at x in [0, 1]; x outside counts as the nearer
/// end, NaN as 0. Within 0.022 of matplotlib's.
std::array<float, 3> Viridis(float x);

}  // namespace pbrt::imgtool
