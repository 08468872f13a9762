#pragma once

#include <string>

#include "materials/material_text.h"

namespace pbrt::test {

// Pieces of the tests of a feather's cells.

constexpr auto kMode = TransportMode::Radiance;
inline const SampledWavelengths kLambda = SampledWavelengths::Of({450, 520, 590, 660});
inline const Frame kStraight{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const std::string kGrid = " \"float cellsacross\" 40 \"float cellsalong\" 25 ";
inline const std::string kVaried =
    " \"float cellthickness\" 10 \"float celltilt\" .05 \"float cellbend\" .03 ";

inline MaterialText Vane(const std::string &parameters) {
    return MaterialText("Material \"featherbarbule\" " + parameters);
}

}  // namespace pbrt::test
