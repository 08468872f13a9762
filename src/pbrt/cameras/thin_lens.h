#pragma once

#include "pbrt/base/camera.h"
#include "pbrt/scene/params.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// The same vector for one point, or sixteen.
template <AnyFloat T>
Vec3<T> Repeated(Vector3f v) {
    return {T{} + v.x, T{} + v.y, T{} + v.z};
}

/// Rays whose origin and direction are affine in the position on the film, and which a thin lens
/// bends: what perspective and orthographic cameras share. In rendering space.
class ThinLensRays {
  public:
    /// Origin or direction at film position (0, 0) and what it changes per pixel, in camera space.
    struct Affine {
        Vector3f start, perX, perY;
    };

    ThinLensRays() = default;
    /// Reads `lensradius` and `focaldistance`; an error where rays would be made with over- or
    /// underflow.
    static ThinLensRays Create(ParamDict &params, const CameraContext &context,
                               const Affine &origin, const Affine &direction);

    const CameraPlacement &Placement() const { return placement; }
    bool HasLens() const { return lensRadius > 0; }
    const Bounds3f &Origins() const { return origins; }
    Vector3f Right() const { return right; }
    Vector3f Forward() const { return forward; }

    /// See CameraType.
    Ray GenerateRay(Point2f film, Point2f lens, float time) const {
        Point3f o = At(origin, film);
        Vector3f d = At(direction, film);
        if (lensRadius > 0) {
            const Point3f focus = o + (focalDistance / DotAxis(d)) * d;
            const Point2f l = SampleUniformDiskConcentric(lens);
            o = o + lensRadius * (l.x * right + l.y * up);
            d = focus - o;
        }
        return {o, Normalize(d), Infinity, placement.TimeAt(time)};
    }
    RayPacket GenerateRays(const Point2fX16 &film, const Point2fX16 &lens,
                           const FloatX16 &time) const {
        if (lensRadius > 0) {
            RayPacket rays;
            for (int i = 0; i < kPacketSize; ++i)
                rays.Set(i, GenerateRay(Lane(film, i), Lane(lens, i), time[i]));
            return rays;
        }
        return {At(origin, film), Normalize(At(direction, film)), Broadcast<16>(Infinity),
                placement.TimeAt(time)};
    }

  private:
    template <typename T>
    static Vec3<T> At(const Affine &a, Vec2<T> film) {
        return {a.start.x + film.x * a.perX.x + film.y * a.perY.x,
                a.start.y + film.x * a.perX.y + film.y * a.perY.y,
                a.start.z + film.x * a.perX.z + film.y * a.perY.z};
    }
    /// Distance along the axis of a direction, in camera space.
    float DotAxis(Vector3f d) const { return Dot(d, forward); }
    /// Sets origins; false where rays would be made with over- or underflow.
    bool SetOrigins(Point2i resolution);

    CameraPlacement placement;
    Affine origin{}, direction{{0, 0, 1}, {}, {}};
    Vector3f right, up;
    Vector3f forward;  ///< of such length that DotAxis is exact where the camera's transform scales
    Bounds3f origins;
    float lensRadius = 0, focalDistance = 1e6f;
};

}  // namespace pbrt
