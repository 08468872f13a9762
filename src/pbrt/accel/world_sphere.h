#pragma once

#include <optional>

#include "pbrt/accel/query.h"

namespace pbrt {

/// A whole sphere that its transform only moves, scales evenly, mirrors and turns by quarters, so
/// that rays meet it in rendering space, where IntersectQuadric would meet it but for roundings of
/// double.
struct WorldSphere {
    Point3f center;
    double radius;

    static std::optional<WorldSphere> Of(const Shape &shape);
};

/// Embree's callbacks for a sphere that is opaque to the query.
void IntersectBall(const WorldSphere &ball, uint32_t localId,
                   const RTCIntersectFunctionNArguments *args);
void OccludedBall(const WorldSphere &ball, const RTCOccludedFunctionNArguments *args);

}  // namespace pbrt
