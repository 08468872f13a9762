#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "pbrt/base/shape.h"
#include "pbrt/shapes/quadric_reader.h"
#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/solid_angle.h"
#include "pbrt/util/atan2.h"
#include "pbrt/util/math.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

// What surfaces of revolution have in common. Their data stand in object space, with z the axis and
// phi from x to y; renderFromObject places them. Their normals are transformed as normals, so that
// a mirroring transform leaves them on the outside, where triangles' need turning: flipNormal is
// ReverseOrientation alone.
//
// Quadrics are intersected and placed in double precision (object space coordinates are never
// rounded to float), so that the error of a hit is that of rounding its position once.

// D: double or DoubleX16 (by reference: how 128 bytes are passed differs between compilers).

/// o + t d in object space. M: Matrix4 or MatrixX16.
template <typename M, typename T>
inline auto ObjectPoint(const M &objectFromRender, const Vec3<T> &o, const Vec3<T> &d, T t) {
    const auto at = [&](T from, T direction) {
        return ToDouble(from) + ToDouble(t) * ToDouble(direction);
    };
    return PointInDouble(objectFromRender,
                         Vec3<decltype(at(t, t))>{at(o.x, d.x), at(o.y, d.y), at(o.z, d.z)});
}
inline Vector3d ObjectPoint(const Transform &renderFromObject, const Hit &hit, const Ray &ray) {
    return ObjectPoint(renderFromObject.InverseMatrix(), ray.o, ray.d, hit.t);
}

/// Angle about z in [0, 2 pi].
inline float Azimuth(float x, float y) {
    const float phi = FastAtan2(y, x);
    return phi + (phi < 0 ? 2 * Pi : 0);
}

/// Position and normal from object space ones; n: outward, any length.
template <bool kWithError, typename M, typename D, typename T>
inline void PlaceQuadric(const M &renderFromObject, const M &objectFromRender, const Vec3<D> &p,
                         const Vec3<T> &n, MaskFor<T> flipNormal, SurfaceInteractionT<T> *s) {
    s->p = ToFloat(PointInDouble(renderFromObject, p));
    // Rounding of p and of the spawned origin; where large terms cancelled, of double as well.
    if constexpr (kWithError)
        s->pError = Gamma(3) * Abs(s->p) + 4e-15f * AbsPoint(renderFromObject, ToFloat(p));
    const Vec3<T> up = Normalize(Transposed(objectFromRender, n));
    s->n = s->ns = Select(flipNormal, -up, up);
}

/// Fills in what all quadrics share, from object space quantities; n: outward, any length.
template <bool kWithError>
inline SurfaceInteraction PlaceQuadric(const Transform &renderFromObject, Vector3d p, Normal3f n,
                                       bool flipNormal, Vector3f dpdu, Vector3f dpdv, Point2f uv) {
    SurfaceInteraction s;
    PlaceQuadric<kWithError>(renderFromObject.Matrix(), renderFromObject.InverseMatrix(), p, n,
                             flipNormal, &s);
    s.dpdu = s.dpdus = renderFromObject.Vector(dpdu);
    s.dpdv = renderFromObject.Vector(dpdv);
    s.uv = {std::clamp(uv.x, 0.f, 1.f), std::clamp(uv.y, 0.f, 1.f)};
    return s;
}

// Intersection, in object space.

struct Roots {
    double t0, t1;
};

/// Crossings of radius r by a ray, given by its parts across an axis (circle) or in space (sphere).
/// The discriminant comes from the distance at the closest approach (Hearn and Baker), the roots
/// without cancellation (Kahan). r, a float, has an exact square: signs are right for origins
/// 1e-15 r from the surface.
inline std::optional<Roots> CrossRadius(Vector3d o, Vector3d d, double r) {
    const double a = LengthSquared(d), b = -Dot(o, d), c = LengthSquared(o) - r * r;
    if (a == 0 || (c > 0 && b <= 0)) return {};
    const double discriminant = r * r - LengthSquared(o + (b / a) * d);
    if (discriminant < 0) return {};
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    if (q == 0) return Roots{0, 0};
    const double t = q / a, other = c / q;
    return t < other ? Roots{t, other} : Roots{other, t};
}

inline bool InAzimuth(double x, double y, float phiMax) {
    if (phiMax >= 2 * Pi) return true;
    double phi = std::atan2(y, x);
    if (phi < 0) phi += 2 * std::numbers::pi;
    return phi <= phiMax;
}

/// The nearer of two roots that lies in (tMin, tMax] and satisfies `keep(point)`.
template <typename F>
inline std::optional<PrimitiveHit> FirstOf(const Roots &roots, const RayD &ray, F keep) {
    for (const double t : {roots.t0, roots.t1})
        if (t > ray.tMin && t <= ray.tMax && keep(ray.o + t * ray.d)) return PrimitiveHit{t};
    return {};
}

// Bounds.

/// The box center +- half, widened by the rounding of a transform of points as far as `far`.
Bounds3f BoundsAround(const Transform &t, Point3f center, Vector3f half, Point3f far);
/// Half extents of the ellipse (or, with z, ellipsoid) that the unit circle (sphere) becomes.
Vector3f EllipseReach(const Transform &t, bool withZ);
/// All of radius about the axis from zMin to zMax: a whole cylinder, or a disk without height.
Bounds3f TubeBounds(const Transform &t, float radius, float zMin, float zMax);

// Sampling. Q has ObjectArea(), its area in object space, and SampleArea(primitive, u), which is
// uniform by area there.

/// |determinant| of the transform's linear part.
float Volume(const Transform &t);

/// Uniform scale of the transform, or 0 where it is more than a rotation with a uniform scale.
inline float UniformScale(const Transform &t) {
    const Matrix4 &m = t.Matrix();
    const Vector3f x{m[0][0], m[1][0], m[2][0]}, y{m[0][1], m[1][1], m[2][1]},
        z{m[0][2], m[1][2], m[2][2]};
    const float xx = LengthSquared(x), least = 1e-5f * xx;
    const bool similar = std::abs(LengthSquared(y) - xx) <= least &&
                         std::abs(LengthSquared(z) - xx) <= least && AbsDot(x, y) <= least &&
                         AbsDot(y, z) <= least && AbsDot(z, x) <= least;
    return similar ? std::sqrt(xx) : 0;
}

/// Factor by which the transform stretches area about a point with unit normal n in object space.
inline float AreaStretch(const Transform &t, Normal3f n) {
    return Volume(t) * Length(t.Normal(n));
}
/// The same from the unit normal n in rendering space; n goes back by the transpose.
inline float AreaStretchAt(const Transform &t, Normal3f n) {
    const Matrix4 &m = t.Matrix();
    const auto column = [&](int j) { return m[0][j] * n.x + m[1][j] * n.y + m[2][j] * n.z; };
    return Volume(t) / Length(Vector3f{column(0), column(1), column(2)});
}
/// A vector in object space.
inline Vector3f ObjectVector(const Transform &t, Vector3f v) {
    const Matrix4 &m = t.InverseMatrix();
    const auto row = [&](int i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
    return {row(0), row(1), row(2)};
}

/// A point in object space with unit normal n and density 1 / area there.
inline ShapeSample QuadricSample(const Transform &t, Point3f p, Normal3f n, bool flipNormal,
                                 Point2f uv, float area) {
    const Normal3f out = t.Normal(n);
    const float length = Length(out);
    ShapeSample s;
    s.p = t.Point(p);
    s.pError = Gamma(6) * AbsPoint(t.Matrix(), p);
    s.n = out * ((flipNormal ? -1 : 1) / length);
    s.uv = uv;
    s.pdf = 1 / (area * Volume(t) * length);
    return s;
}

/// Density per area of SampleArea where the normal in rendering space is n.
template <typename Q>
inline float QuadricPDFArea(const Q &quadric, Normal3f n) {
    return 1 / (quadric.ObjectArea() * AreaStretchAt(quadric.renderFromObject, n));
}

/// Mean stretch of the area, by the midpoint rule over its parameters.
template <typename Q>
inline float MeanStretch(const Q &quadric, int nU, int nV) {
    double sum = 0;
    for (int i = 0; i < nU; ++i)
        for (int j = 0; j < nV; ++j) {
            const ShapeSample s = *quadric.SampleArea(0, {(i + 0.5f) / nU, (j + 0.5f) / nV});
            sum += 1 / (s.pdf * quadric.ObjectArea());
        }
    return float(sum / (nU * nV));
}

}  // namespace pbrt
