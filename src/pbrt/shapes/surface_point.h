#pragma once

#include <cstdint>

#include "pbrt/util/vecmath.h"

namespace pbrt {

/// What traversal returns: compact, no derivatives. u, v are barycentrics of the second and third
/// vertex for triangles; for bilinear patches the patch's (u, v), or, in planar meshes, the
/// coordinates described at BilinearMesh::planar; 0 for the other shapes.
struct Hit {
    float t;
    float u, v;
    uint32_t geometry;        ///< index into World::geometries
    uint32_t primitive;       ///< triangle, patch... within it
    uint32_t instance = ~0u;  ///< index into World::instances; ~0u: none
};

/// A point on a surface, all in rendering space. n and ns are unit and n points to the outside as
/// ReverseOrientation and handedness say; ns lies in n's hemisphere.
struct SurfacePoint {
    Point3f p;
    Vector3f pError;  ///< conservative absolute error of p per axis, with the rounding of a spawned
                      ///< ray's origin and of its test against this primitive
    Normal3f n, ns;
    Vector3f dpdu, dpdv;  ///< of the true surface
    Vector3f dpdus;       ///< shading tangent: the BSDF frame's x (S where given)
    Point2f uv;
    int faceIndex = 0;

    Frame ShadingFrame() const { return Frame::FromZTangent(ns, dpdus); }
    /// Origin for a ray that leaves into direction w without meeting this surface again.
    Point3f OffsetOrigin(Vector3f w) const {
        const float d = Dot(Abs(n), pError);
        return p + n * (Dot(w, n) < 0 ? -d : d);
    }
};

/// A point drawn on an emitter. pdf per unit area, or per unit solid angle, as the call says.
struct ShapeSample {
    Point3f p;
    Vector3f pError;
    Normal3f n;
    Point2f uv;
    float pdf;
};

/// Cone that holds every normal of the primitive: axis and cosine of its half angle.
struct NormalCone {
    Vector3f axis;
    float cosTheta;
};

}  // namespace pbrt
