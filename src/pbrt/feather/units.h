#pragma once

namespace pbrt::feather {

/// A length in nanometres: film thickness or wavelength.
template <class V>
struct Nm {
    V value;
    friend constexpr V operator/(const Nm &a, const Nm &b) { return a.value / b.value; }
};

/// An angle in radians, as everywhere in the model; the scene's `rotation` alone is in degrees.
template <class V>
struct Radian {
    V value;
};

}  // namespace pbrt::feather
