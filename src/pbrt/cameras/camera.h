#pragma once

#include <optional>

#include "pbrt/scene/description.h"
#include "pbrt/util/ray_packet.h"
#include "pbrt/util/sampling.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// Pinhole or thin-lens camera, perspective or orthographic, at rest.
///
/// Rays start in rendering space, which is chosen here (PBRT_FORMAT 3.1, render-coord-sys):
/// world axes with the camera at the origin ("cameraworld"), "camera" or "world".
class Camera {
  public:
    /// Errors go to the log; the camera is usable all the same. `resolution` of the full film.
    static Camera Create(const SceneDescription &scene, Point2i resolution, Diagnostics &log);

    /// `film` in pixels of the full picture, `lens` and `time` in [0, 1). d is unit. The ray's time
    /// runs from 0 at TransformTimes' start to 1 at its end and stays there before and after.
    Ray GenerateRay(Point2f film, Point2f lens, float time) const {
        Point3f o = OriginAt(film);
        Vector3f d = DirectionAt(film);
        if (lensRadius > 0) {
            const Point3f focus = o + (focalDistance / DotAxis(d)) * d;
            const Point2f l = SampleUniformDiskConcentric(lens);
            o = o + lensRadius * (l.x * right + l.y * up);
            d = focus - o;
        }
        return {o, Normalize(d), Infinity, TimeAt(time)};
    }
    /// The same sixteen times.
    RayPacket GenerateRays(const Point2fX16 &film, const Point2fX16 &lens,
                           const FloatX16 &time) const {
        if (lensRadius > 0) {
            RayPacket rays;
            for (int i = 0; i < kPacketSize; ++i)
                rays.Set(i, GenerateRay(Lane(film, i), Lane(lens, i), time[i]));
            return rays;
        }
        return {OriginAt(film), Normalize(DirectionAt(film)), Broadcast<16>(Infinity),
                TimeAt(time)};
    }
    const Transform &RenderFromWorld() const { return renderFromWorld; }
    const Transform &RenderFromCamera() const { return renderFromCamera; }
    const Transform &CameraFromWorld() const { return cameraFromWorld; }
    /// Screen window and field of view, as 4 x 4 map from world to [0, 1]^2 x depth: for metadata.
    const Transform &NDCFromWorld() const { return ndcFromWorld; }

    /// Steps of a surface point per pixel in x and y (to the right and down), for texture
    /// filtering: the tangent-plane intersections of the neighbouring pixels' rays, taken from the
    /// film's centre.
    template <AnyFloat T>
    void ApproximateStep(Vec3<T> p, Vec3<T> n, float scale, Vec3<T> *dpdx, Vec3<T> *dpdy) const;

    /// Holds the origins of all rays.
    const Bounds3f &Origins() const { return origins; }

    bool HasLens() const { return lensRadius > 0; }
    float ShutterOpen() const { return shutterOpen; }
    float ShutterClose() const { return shutterClose; }

  private:
    /// Sets origins; false where rays would be made with over- or underflow.
    bool SetOrigins(Point2i resolution);
    float DotAxis(Vector3f d) const { return Dot(d, forward); }
    template <typename T>
    Vec3<T> OriginAt(Vec2<T> film) const {
        return Affine(origin, originPerX, originPerY, film);
    }
    template <typename T>
    Vec3<T> DirectionAt(Vec2<T> film) const {
        return Affine(direction, directionPerX, directionPerY, film);
    }
    template <typename T>
    static Vec3<T> Affine(Vector3f start, Vector3f perX, Vector3f perY, Vec2<T> at) {
        return {start.x + at.x * perX.x + at.y * perY.x, start.y + at.x * perX.y + at.y * perY.y,
                start.z + at.x * perX.z + at.y * perY.z};
    }
    template <typename T>
    T TimeAt(T time) const {
        return Min(Max(timeOpen + time * (timeClose - timeOpen), 0.f), 1.f);
    }

    // Affine in film position: origin and direction at (0, 0) and their change per pixel.
    Point3f origin;
    Vector3f originPerX, originPerY, direction, directionPerX, directionPerY;
    Vector3f right, up, forward;
    float downOfFrame = -1;  ///< sense of "down" along Cross(forward, right): 1 if mirrored
    Bounds3f origins;
    float lensRadius = 0, focalDistance = 1e6f, shutterOpen = 0, shutterClose = 1;
    float timeOpen = 0, timeClose = 1;  ///< the shutter's in the time of rays, not clamped
    float pixelAngle = 0;               ///< steps per unit distance, perspective
    float pixelSize = 0;                ///< steps, orthographic
    Transform renderFromWorld, renderFromCamera, cameraFromWorld, ndcFromWorld;
};

template <AnyFloat T>
void Camera::ApproximateStep(Vec3<T> p, Vec3<T> n, float scale, Vec3<T> *dpdx,
                             Vec3<T> *dpdy) const {
    const auto all = [](Vector3f v) { return Vec3<T>{T{} + v.x, T{} + v.y, T{} + v.z}; };
    const Vec3<T> away = p - all(renderFromCamera.Point({0, 0, 0}));
    const T step = scale * (pixelAngle * Length(away) + pixelSize);
    // A square of that size facing the camera, projected along the view onto the tangent plane.
    const Vec3<T> view = pixelAngle > 0 ? Normalize(away) : all(Normalize(forward));
    const T cosine = Dot(n, view);
    const T safe = CopySign(Max(Abs(cosine), 0.05f), cosine);
    const auto project = [&](Vec3<T> v) { return v - view * (Dot(n, v) / safe); };
    const auto frame = FrameT<T>::FromZTangent(view, all(right));
    *dpdx = step * project(frame.x);
    *dpdy = (step * downOfFrame) * project(frame.y);
}

}  // namespace pbrt
