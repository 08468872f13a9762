#pragma once

#include <optional>

#include "pbrt/shapes/bilinear.h"
#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

// Intersections that Embree does not know, in double precision (float's roots are off by 1e-4 of a
// sphere's radius near grazing).

/// Object space from rendering space, inverted in double from the float matrix, so that a surface
/// lies where SurfaceAt puts its points.
class ObjectFromRender {
  public:
    explicit ObjectFromRender(const Transform &renderFromObject);
    Vector3d Point(Vector3d p) const {
        return {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3],
                m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3],
                m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3]};
    }
    Vector3d Vector(Vector3d v) const {
        return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
                m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
    }

  private:
    double m[3][4];
};

/// A ray in object space, in double; 0 <= tMin.
struct RayD {
    Vector3d o, d;
    double tMin, tMax;
};

/// Smallest t in (tMin, tMax] of a hit.
std::optional<double> IntersectQuadric(const Sphere &sphere, const RayD &ray);
std::optional<double> IntersectQuadric(const Disk &disk, const RayD &ray);
std::optional<double> IntersectQuadric(const Cylinder &cylinder, const RayD &ray);

struct PatchHit {
    double t, u, v;
};
/// Nearest hit of the bilinear surface in (tMin, tMax].
std::optional<PatchHit> IntersectPatch(const Patch &patch, const RayD &ray);

/// (u, v) of a point on or near the patch, projected along its normal n there.
Point2f InvertPatch(const Patch &patch, Point3f p, Normal3f n);

}  // namespace pbrt
