#pragma once

#include <concepts>

namespace pbrt::feather {

/// A length in nanometres: film thickness or wavelength.
template <std::floating_point T>
struct Nm {
    T value;
    friend constexpr T operator/(Nm a, Nm b) { return a.value / b.value; }
};

/// An angle in radians, as everywhere in the model; the scene's `rotation` alone is in degrees.
template <std::floating_point T>
struct Radian {
    T value;
};

}  // namespace pbrt::feather
