#pragma once

#include "pbrt/cameras/orthographic.h"
#include "pbrt/cameras/perspective.h"
#include "pbrt/cameras/spherical.h"
#include "pbrt/scene/description.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of cameras. Parser, messages and tests follow from it.
using CameraTypes = TypeList<PerspectiveCamera, OrthographicCamera, SphericalCamera>;
using Camera = CameraTypes::Variant;

template <CameraType C>
inline constexpr bool kIsCamera = true;
static_assert(CameraTypes::All([]<typename C>() { return kIsCamera<C>; }));

/// Errors go to the log; the camera is usable all the same. `resolution` of the full film.
Camera CreateCamera(const SceneDescription &scene, Point2i resolution, Diagnostics &log);
/// The same by its parameters; of the scene its transforms, times and options are read.
Camera CreateCamera(std::string_view type, ParamDict &params, const SceneDescription &scene,
                    Point2i resolution);

// See CameraType.
inline const CameraPlacement &Placement(const Camera &camera) {
    return Dispatch(camera, [](const auto &c) -> const CameraPlacement & { return c.Placement(); });
}
inline bool HasLens(const Camera &camera) {
    return Dispatch(camera, [](const auto &c) { return c.HasLens(); });
}
/// Holds the origins of all rays at all times.
inline Bounds3f Origins(const Camera &camera) {
    const Bounds3f atRest = Dispatch(camera, [](const auto &c) { return c.Origins(); });
    if (!Placement(camera).Moves()) return atRest;
    Bounds3f all;
    for (const Transform &key : Placement(camera).motion)
        all.Grow(key.Bounds(atRest));
    return all;
}
inline Transform NDCFromWorld(const Camera &camera) {
    return Dispatch(
        camera, [](const auto &c) { return c.NDCFromCamera() * c.Placement().cameraFromWorld; });
}
inline Ray GenerateRay(const Camera &camera, Point2f film, Point2f lens, float time) {
    return Dispatch(camera, [&](const auto &c) {
        const Ray ray = c.GenerateRay(film, lens, time);
        return c.Placement().Moves() ? c.Placement().Moved(ray) : ray;
    });
}
/// GenerateRay sixteen times.
inline RayPacket GenerateRays(const Camera &camera, const Point2fX16 &film, const Point2fX16 &lens,
                              const FloatX16 &time) {
    return Dispatch(camera, [&]<typename C>(const C &c) {
        RayPacket rays;
        if constexpr (C::kTraits.hasPackets) {
            rays = c.GenerateRays(film, lens, time);
        } else {
            for (int i = 0; i < kPacketSize; ++i)
                rays.Set(i, c.GenerateRay(Lane(film, i), Lane(lens, i), time[i]));
        }
        if (c.Placement().Moves()) [[unlikely]]
            for (int i = 0; i < kPacketSize; ++i)
                rays.Set(i, c.Placement().Moved(rays.At(i)));
        return rays;
    });
}

/// View of one point, or of sixteen; of a moving camera at time 0.
template <AnyFloat T>
CameraView<T> ViewAt(const Camera &camera, Vec3<T> p) {
    return Dispatch(camera, [&]<typename C>(const C &c) {
        if constexpr (C::kTraits.hasPackets || std::same_as<T, float>) {
            return c.ViewAt(p);
        } else {
            CameraView<FloatX16> views;
            for (int i = 0; i < kPacketSize; ++i) {
                const CameraView<float> view = c.ViewAt(Lane(p, i));
                SetLane(&views.direction, i, view.direction);
                SetLane(&views.right, i, view.right);
                views.step.Set(i, view.step);
            }
            return views;
        }
    });
}

/// Steps of a surface point per pixel in x and y (to the right and down), times `scale`, for
/// texture filtering: the tangent-plane intersections of the neighbouring pixels' rays.
template <AnyFloat T>
void ApproximateStep(const Camera &camera, Vec3<T> p, Vec3<T> n, float scale, Vec3<T> *dpdx,
                     Vec3<T> *dpdy) {
    const CameraView<T> view = ViewAt(camera, p);
    const T step = scale * view.step;
    // A square of that size facing the camera, projected along the view onto the tangent plane.
    const T cosine = Dot(n, view.direction);
    const T safe = CopySign(Max(Abs(cosine), 0.05f), cosine);
    const auto project = [&](Vec3<T> v) { return v - view.direction * (Dot(n, v) / safe); };
    const auto frame = FrameT<T>::FromZTangent(view.direction, view.right);
    *dpdx = step * project(frame.x);
    *dpdy = (step * Placement(camera).downOfFrame) * project(frame.y);
}

}  // namespace pbrt
