#pragma once

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Perlin's improved noise (Perlin 2002, "Improving Noise"), the same at the same place always: 0
/// at whole coordinates, within +-1.04, twice differentiable, of period 256 along each axis.
/// Coordinates from 2^24 on count as whole, as floats are there.
float Noise(Point3f p);

/// The sum over octaves i of roughness^i Noise(1.99^i p): 1.99 for 2, so that the lattices do not
/// meet. Octaves beyond what the pixel's steps dpdx, dpdy can show are left out, the last one shown
/// faded in by a cubic step (Pharr, Jakob, Humphreys, "Physically Based Rendering"); without steps
/// all count. octaves in [0, 64], roughness in [0, 2].
float FBm(Point3f p, Vector3f dpdx, Vector3f dpdy, float roughness, int octaves);

/// The same of the noise's absolute value. Octaves that are left out count by its mean, 0.2, the
/// last one shown, too, as in pbrt-v4.
float Turbulence(Point3f p, Vector3f dpdx, Vector3f dpdy, float roughness, int octaves);

}  // namespace pbrt
