#pragma once

#include "pbrt/util/transform.h"

namespace pbrt {

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

}  // namespace pbrt
