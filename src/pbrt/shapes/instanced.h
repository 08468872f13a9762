#pragma once

#include <algorithm>

#include "pbrt/base/ray_tracer.h"
#include "pbrt/base/surface_interaction.h"
#include "pbrt/shapes/rounding.h"

namespace pbrt {

/// Transform of an instance at a ray's time: linear between keys, entry by entry, as the ray tracer
/// has it.
inline Transform TransformAt(const Instance &instance, float time) {
    if (!instance.Moves()) return instance.Key(0);
    const size_t nSteps = instance.NKeys() - 1;
    const float at = time * float(nSteps);
    const size_t key = std::min(size_t(at), nSteps - 1);
    const Matrix4 from = instance.Key(key).Matrix(), to = instance.Key(key + 1).Matrix();
    Matrix4 m;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            m[i][j] = Lerp(at - float(key), from[i][j], to[i][j]);
    return Transform::FromMatrix(m).value_or(instance.Key(0));
}

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
