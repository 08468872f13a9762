#pragma once

#include "pbrt/base/surface_interaction.h"
#include "pbrt/shapes/rounding.h"

namespace pbrt {

/// A surface point of an instance's object, in rendering space. pError grows by the transform's
/// rounding and by that of the way back, which a spawned ray's origin takes before it is
/// tested against the object.
inline SurfaceInteraction FromInstance(const Transform &renderFromObject,
                                       const SurfaceInteraction &s) {
    const Matrix4 &m = renderFromObject.Matrix();
    SurfaceInteraction r = s;
    r.p = renderFromObject.Point(s.p);
    const Vector3f back = Gamma(5) * AbsPoint(renderFromObject.InverseMatrix(), r.p);
    r.pError = Gamma(5) * AbsPoint(m, s.p) + AbsVector(m, s.pError + back);
    // As in meshes made in place, shading normals decide the side.
    r.ns = Normalize(renderFromObject.Normal(s.ns));
    r.n = FaceForward(Normalize(renderFromObject.Normal(s.n)), r.ns);
    if (s.startBehind != 0) r.startBehind = s.startBehind * Length(renderFromObject.Vector(s.n));
    r.dpdu = renderFromObject.Vector(s.dpdu);
    r.dpdv = renderFromObject.Vector(s.dpdv);
    r.dpdus = renderFromObject.Vector(s.dpdus);
    return r;
}

}  // namespace pbrt
