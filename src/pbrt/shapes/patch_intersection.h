#pragma once

#include <optional>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/patch.h"

namespace pbrt {

/// Nearest hit of the bilinear surface in (tMin, tMax].
std::optional<PrimitiveHit> IntersectPatch(const Patch &patch, const RayD &ray);

/// (u, v) of a point on or near the patch, projected along its normal n there.
Point2f InvertPatch(const Patch &patch, Point3f p, Normal3f n);

}  // namespace pbrt
