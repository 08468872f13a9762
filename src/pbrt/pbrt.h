#pragma once

/// The number type of the renderer. Light transport runs in float; double is for oracles and sums.
namespace pbrt {
using Float = float;
}  // namespace pbrt
