#pragma once

#include <cstdint>

#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// A point on a surface, all in rendering space. n and ns are unit and n points to the outside as
/// ReverseOrientation and handedness say; ns lies in n's hemisphere.
template <typename T>
struct SurfaceInteractionT {
    Vec3<T> p;
    Vec3<T> pError;  ///< conservative absolute error of p per axis, with the rounding of a spawned
                     ///< ray's origin and of its test against this primitive
    Vec3<T> n, ns;
    Vec3<T> dpdu, dpdv;  ///< of the true surface
    Vec3<T> dpdus;       ///< shading tangent: the BSDF frame's x (S where given)
    Vec2<T> uv;
    IntOf<T> faceIndex{};
    T startBehind{};  ///< rays that leave start so far back against their direction; 0 but for
                      ///< curves, see CurveSet::SurfaceAt

    /// x along dpdus, y on dpdv's side, z = ns. Left-handed where (dpdu, dpdv, n) are, as on all
    /// mirrored surfaces: what a material does is then mirrored with its surface.
    FrameT<T> ShadingFrame() const {
        FrameT<T> frame = FrameT<T>::FromZTangent(ns, dpdus);
        frame.y = Select(Dot(Cross(dpdu, dpdv), n) < 0, -frame.y, frame.y);
        return frame;
    }
    /// For fibres, met by a ray of direction d: the same with z towards the viewer, so that what is
    /// met at an offset along y is met there from either side. Curves face the ray but for
    /// roundings at their rim.
    FrameT<T> FibreFrame(Vec3<T> d) const {
        FrameT<T> frame = ShadingFrame();
        frame.z = Select(Dot(frame.z, d) > 1e-6f, -frame.z, frame.z);
        return frame;
    }
    /// Origin for a ray that leaves into direction w, unit, without meeting this surface again.
    Vec3<T> OffsetOrigin(Vec3<T> w) const {
        const T d = Dot(Abs(n), pError);
        return p + n * Select(Dot(w, n) < 0, -d, d) - startBehind * w;
    }
};
using SurfaceInteraction = SurfaceInteractionT<float>;
using SurfaceInteractionX16 = SurfaceInteractionT<FloatX16>;

/// Lane i.
inline SurfaceInteraction Lane(const SurfaceInteractionX16 &s, int i) {
    return {Lane(s.p, i),    Lane(s.pError, i), Lane(s.n, i),  Lane(s.ns, i),  Lane(s.dpdu, i),
            Lane(s.dpdv, i), Lane(s.dpdus, i),  Lane(s.uv, i), s.faceIndex[i], s.startBehind[i]};
}
inline void SetLane(SurfaceInteractionX16 *s, int i, const SurfaceInteraction &value) {
    SetLane(&s->p, i, value.p);
    SetLane(&s->pError, i, value.pError);
    SetLane(&s->n, i, value.n);
    SetLane(&s->ns, i, value.ns);
    SetLane(&s->dpdu, i, value.dpdu);
    SetLane(&s->dpdv, i, value.dpdv);
    SetLane(&s->dpdus, i, value.dpdus);
    SetLane(&s->uv, i, value.uv);
    s->faceIndex.Set(i, value.faceIndex);
    s->startBehind.Set(i, value.startBehind);
}

}  // namespace pbrt
