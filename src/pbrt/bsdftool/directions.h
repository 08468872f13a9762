#pragma once

#include <string>
#include <vector>

#include "pbrt/util/diagnostics.h"
#include "pbrt/util/vecmath.h"

namespace pbrt::bsdftool {

/// A unit direction of the local frame, in double so that the oracle can use it.
struct LocalDirection {
    double x, y, z;
    Vector3f ToFloat() const { return {float(x), float(y), float(z)}; }
};

struct DirectionPair {
    LocalDirection wo, wi;
};

/// Lines of `wo_x,wo_y,wo_z,wi_x,wi_y,wi_z` after exactly that header; directions are normalised.
/// A line that is not six numbers, or a direction that is not finite or 0, is an error at its line.
std::vector<DirectionPair> ReadDirections(const std::string &fileName, Diagnostics &log);

/// theta from z, phi from x towards y; degrees.
LocalDirection Spherical(double theta, double phi);

}  // namespace pbrt::bsdftool
