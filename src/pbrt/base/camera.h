#pragma once

#include <algorithm>
#include <concepts>
#include <vector>

#include "pbrt/base/plug_in.h"
#include "pbrt/util/ray_packet.h"
#include "pbrt/util/transform.h"

// The contract of a camera: the ray that each position on the film sees along. The closed list of
// cameras is in pbrt/cameras/cameras.h.

namespace pbrt {

class ParamDict;

/// Position of a camera and times of its shutter; the same for all types. Rendering space is
/// that of all rays and shapes (PBRT_FORMAT 3.1, render-coord-sys): world axes with the camera at
/// the origin ("cameraworld"), "camera" or "world". Camera space: x to the right, y up, z forward.
struct CameraPlacement {
    Transform renderFromWorld, renderFromCamera, cameraFromWorld;
    float shutterOpen = 0, shutterClose = 1;
    float timeOpen = 0, timeClose = 1;  ///< the shutter's in the time of rays, not clamped
    /// -1 if the film's "down" runs against Cross(forward, right), as usual; 1 if the camera's
    /// transform mirrors.
    float downOfFrame = -1;
    /// Keys of a moving camera: each maps rendering space as the camera at rest sees it to where
    /// that is at equal steps of the rays' time, to be joined linearly by entries. The transforms
    /// above are those at time 0. Empty: the camera rests.
    std::vector<Transform> motion;

    /// The time of a ray, u in [0, 1): from 0 at TransformTimes' start to 1 at its end; it stays
    /// there before and after.
    template <AnyFloat T>
    T TimeAt(T u) const {
        return Min(Max(timeOpen + u * (timeClose - timeOpen), 0.f), 1.f);
    }
    bool Moves() const { return !motion.empty(); }
    /// A ray of the camera at rest, as the moving one has it at the ray's time.
    Ray Moved(const Ray &ray) const {
        const float at = ray.time * float(motion.size() - 1);
        const size_t key = std::min(size_t(at), motion.size() - 2);
        const float t = at - float(key);
        const Transform &a = motion[key], &b = motion[key + 1];
        return {(1 - t) * a.Point(ray.o) + t * b.Point(ray.o),
                Normalize((1 - t) * a.Vector(ray.d) + t * b.Vector(ray.d)), ray.tMax, ray.time};
    }
    /// The camera's axes in rendering space, of any length; at time 0.
    Vector3f Right() const { return renderFromCamera.Vector({1, 0, 0}); }
    Vector3f Up() const { return renderFromCamera.Vector({0, 1, 0}); }
    Vector3f Forward() const { return renderFromCamera.Vector({0, 0, 1}); }
};

/// Arguments of a camera besides its own parameters.
struct CameraContext {
    CameraPlacement placement;
    Point2i resolution;  ///< of the full image, pixels
};

/// View of a point from a camera, in rendering space.
template <typename T>
struct CameraView {
    Vec3<T> direction;  ///< of the ray that meets the point, unit
    Vec3<T> right;      ///< on the film, at the point; any length, not along `direction`
    T step;             ///< distance between the rays of neighbouring pixels there
};

/// Members that a camera may have beyond the compulsory ones.
struct CameraTraits {
    /// Has GenerateRays(Point2fX16 film, Point2fX16 lens, FloatX16 time) const, which gives a
    /// RayPacket, and ViewAt(Point3fX16) const: the same sixteen times, but for rounding. Without
    /// it they are called one by one.
    bool hasPackets = false;
};

namespace detail {
template <typename C>
concept HasCameraPackets = requires(const C c, const Point2fX16 &film, const FloatX16 &time,
                                    const Point3fX16 &p) {
    { c.GenerateRays(film, film, time) } -> std::same_as<RayPacket>;
    { c.ViewAt(p) } -> std::same_as<CameraView<FloatX16>>;
};
}  // namespace detail

/// Copyable and immutable once made; any thread may read it. It rests: what moves it is
/// CameraPlacement::motion, which cameras.h applies to its rays.
///
///   kTraits                  CameraTraits
///   Create(params, context)  reads all parameters but the shutter's; mistakes are reported through
///                            params, and the camera is usable all the same
///   Placement()              that of the context
///   GenerateRay(film, lens, time)   `film` in pixels of the full image, (0, 0) its upper left
///                            corner; `lens` and `time` in [0, 1). In rendering space, d unit, time
///                            by Placement().TimeAt
///   HasLens()                false: `lens` is not read, and nobody works it out
///   Origins()                holds the origins of all rays of the camera at rest, in rendering
///                            space
///   ViewAt(p)                for texture filtering; may be an approximation, as that of the
///   camera's
///                            axis. p in rendering space
///   NDCFromCamera()          from camera space to [0, 1]^2 over the film, y down, x depth; for the
///                            image's metadata. Transform() where there is no such matrix
template <typename C>
concept CameraType = PlugInType<C> && std::copyable<C> &&
    requires(const C c, ParamDict &params, const CameraContext &context, Point2f film, float time,
             Point3f p) {
    { C::kTraits } -> std::same_as<const CameraTraits &>;
    { C::Create(params, context) } -> std::same_as<C>;
    { c.Placement() } -> std::same_as<const CameraPlacement &>;
    { c.GenerateRay(film, film, time) } -> std::same_as<Ray>;
    { c.HasLens() } -> std::same_as<bool>;
    { c.Origins() } -> std::same_as<Bounds3f>;
    { c.ViewAt(p) } -> std::same_as<CameraView<float>>;
    { c.NDCFromCamera() } -> std::same_as<Transform>;
} && detail::AsAnnounced<C::kTraits.hasPackets, detail::HasCameraPackets<C>>;

}  // namespace pbrt
