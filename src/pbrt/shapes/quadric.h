#pragma once

#include <algorithm>

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/surface_interaction.h"
#include "pbrt/shapes/types.h"
#include "pbrt/util/atan2.h"

namespace pbrt {

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

/// A point near the sphere moved onto it.
template <typename D, typename T>
inline Vec3<D> OnSphere(const Vec3<D> &p, T radius) {
    const D scale = ToDouble(radius) / Sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return {p.x * scale, p.y * scale, p.z * scale};
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

/// Polar angles of a sphere's lower and upper rim, pi and 0 where it is whole.
inline float ThetaZMin(const Sphere &s) {
    return s.zMin <= -s.radius ? Pi : std::acos(s.zMin / s.radius);
}
inline float ThetaZMax(const Sphere &s) {
    return s.zMax >= s.radius ? 0 : std::acos(s.zMax / s.radius);
}

/// (u, v) of a point on the sphere in object space: u along the azimuth, v from zmin to zmax.
inline Point2f SphereUV(const Sphere &sphere, Vector3f p) {
    const float thetaMin = ThetaZMin(sphere), thetaMax = ThetaZMax(sphere);
    const float theta = FastAtan2(std::sqrt(Sqr(p.x) + Sqr(p.y)), p.z);
    return {Azimuth(p.x, p.y) / sphere.phiMax, (theta - thetaMin) / (thetaMax - thetaMin)};
}

template <bool kWithError>
inline SurfaceInteraction SphereSurface(const Sphere &sphere, const Hit &hit, const Ray &ray) {
    const Vector3d p = OnSphere(ObjectPoint(sphere.renderFromObject, hit, ray), sphere.radius);
    const Vector3f q = ToFloat(p);
    // At the poles dpdu vanishes; keep a direction.
    const float rho = std::sqrt(Sqr(q.x) + Sqr(q.y)), least = 1e-5f * sphere.radius;
    const float cosPhi = rho > least ? q.x / rho : 1, sinPhi = rho > least ? q.y / rho : 0;
    const float dTheta = ThetaZMax(sphere) - ThetaZMin(sphere);
    const Vector3f dpdu = sphere.phiMax * std::max(rho, least) * Vector3f{-sinPhi, cosPhi, 0};
    const Vector3f dpdv = dTheta * Vector3f{q.z * cosPhi, q.z * sinPhi, -rho};
    return PlaceQuadric<kWithError>(sphere.renderFromObject, p, q, sphere.flipNormal, dpdu, dpdv,
                                    SphereUV(sphere, q));
}

template <bool kWithError>
inline SurfaceInteraction DiskSurface(const Disk &disk, const Hit &hit, const Ray &ray) {
    Vector3d p = ObjectPoint(disk.renderFromObject, hit, ray);
    p.z = disk.height;
    const float x = float(p.x), y = float(p.y), width = disk.radius - disk.innerRadius;
    const float r = std::sqrt(Sqr(x) + Sqr(y)), least = 1e-5f * disk.radius;
    const float cosPhi = r > least ? x / r : 1, sinPhi = r > least ? y / r : 0;
    const Vector3f dpdu = disk.phiMax * std::max(r, least) * Vector3f{-sinPhi, cosPhi, 0};
    const Vector3f dpdv = -width * Vector3f{cosPhi, sinPhi, 0};
    return PlaceQuadric<kWithError>(disk.renderFromObject, p, {0, 0, 1}, disk.flipNormal, dpdu,
                                    dpdv, {Azimuth(x, y) / disk.phiMax, (disk.radius - r) / width});
}

template <bool kWithError>
inline SurfaceInteraction CylinderSurface(const Cylinder &cylinder, const Hit &hit,
                                          const Ray &ray) {
    Vector3d p = ObjectPoint(cylinder.renderFromObject, hit, ray);
    const double toSurface = cylinder.radius / std::sqrt(p.x * p.x + p.y * p.y);
    p.x *= toSurface;
    p.y *= toSurface;
    const Vector3f q = ToFloat(p);
    const float height = cylinder.zMax - cylinder.zMin;
    return PlaceQuadric<kWithError>(
        cylinder.renderFromObject, p, {q.x, q.y, 0}, cylinder.flipNormal,
        cylinder.phiMax * Vector3f{-q.y, q.x, 0}, {0, 0, height},
        {Azimuth(q.x, q.y) / cylinder.phiMax, (q.z - cylinder.zMin) / height});
}

}  // namespace pbrt
