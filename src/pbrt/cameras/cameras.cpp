#include "pbrt/cameras/cameras.h"

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/util/motion.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr FloatParam kShutterOpen{"shutteropen", "s", 0, -1e30f, 1e30f, "when the shutter opens"};
constexpr FloatParam kShutterClose{"shutterclose", "s",   1,
                                   -1e30f,         1e30f, "when the shutter closes"};

/// Sets the spaces. Each directly, for a product of one with the other's inverse, both rounded,
/// would skew the world against the camera by 1e-8 of its coordinates.
void PlaceInSpace(CameraPlacement *placement, std::string_view space) {
    if (space == "camera") {
        placement->renderFromWorld = placement->cameraFromWorld;
        return;
    }
    const Transform worldFromCamera = placement->cameraFromWorld.Inverse();
    if (space == "world") {
        placement->renderFromCamera = worldFromCamera;
        return;
    }
    const Transform fromEye = Transform::Translate(-worldFromCamera.Point({0, 0, 0}));
    placement->renderFromCamera = fromEye * worldFromCamera;
    placement->renderFromWorld = fromEye;
}

void ReadShutter(ParamDict &params, const SceneDescription &scene, CameraPlacement *placement) {
    placement->shutterOpen = params.GetOneFloat(kShutterOpen);
    placement->shutterClose = params.GetOneFloat(kShutterClose);
    if (!(placement->shutterClose > placement->shutterOpen))
        params.Error(kShutterClose.name, "\"shutterclose\" must be later than \"shutteropen\"");
    const double start = scene.transformStart, duration = scene.transformEnd - start;
    const auto rayTime = [&](double t) {
        return float(std::clamp((t - start) / std::max(duration, 1e-30), -1e30, 1e30));
    };
    placement->timeOpen = rayTime(placement->shutterOpen);
    placement->timeClose = rayTime(placement->shutterClose);
}

/// `end`: cameraFromWorld at the end of TransformTimes.
void SetMotion(ParamDict &params, const Transform &end, CameraPlacement *placement) {
    if (placement->cameraFromWorld == end) return;
    const Transform &from = placement->renderFromCamera;
    // Through the world: rendering space stays where it is.
    const Transform to = placement->renderFromWorld * end.Inverse();
    if (from.SwapsHandedness() != to.SwapsHandedness())
        return params.Error("the camera is mirrored at one end of its motion only");
    std::vector<Transform> keys = KeysBetween(from, to);
    keys.insert(keys.begin(), from);
    keys.push_back(to);
    for (const Transform &key : keys) {
        const Transform moved = key * from.Inverse();
        if (!IsInRange(key.Point({0, 0, 0})) || !HasSafeLength(moved.Vector({1, 0, 0})) ||
            !HasSafeLength(moved.Vector({0, 1, 0})) || !HasSafeLength(moved.Vector({0, 0, 1}))) {
            placement->motion.clear();
            return params.Error("the camera's motion makes rays that cannot be traced");
        }
        placement->motion.push_back(moved);
    }
}

CameraPlacement Place(ParamDict &params, const SceneDescription &scene) {
    CameraPlacement placement;
    placement.cameraFromWorld = scene.cameraFromWorld[0];
    PlaceInSpace(&placement, scene.options.renderCoordSys);
    const Vector3f down = Cross(placement.Forward(), placement.Right());
    placement.downOfFrame = Dot(down, placement.Up()) < 0 ? 1 : -1;
    SetMotion(params, scene.cameraFromWorld[1], &placement);
    ReadShutter(params, scene, &placement);
    return placement;
}

}  // namespace

Camera CreateCamera(const SceneDescription &scene, Point2i resolution, Diagnostics &log) {
    const std::string type =
        scene.camera.type.empty() ? std::string(PerspectiveCamera::kName) : scene.camera.type;
    ParamDict params(scene.camera.params, scene.camera.loc, fmt::format("camera \"{}\"", type),
                     scene.camera.colorSpace, &log, scene.dir);
    return CreateCamera(type, params, scene, resolution);
}

Camera CreateCamera(std::string_view type, ParamDict &params, const SceneDescription &scene,
                    Point2i resolution) {
    Camera camera;
    const bool known = CameraTypes::Visit(type, [&]<typename C>() {
        camera = C::Create(params, {Place(params, scene), resolution});
        params.ReportUnused();
    });
    if (!known) params.Error(UnknownName("camera", type, CameraTypes::kNames));
    return camera;
}

}  // namespace pbrt
