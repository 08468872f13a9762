#include "pbrt/cameras/camera.h"

#include <fmt/format.h>

#include "pbrt/util/range.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 2> kNames{"perspective", "orthographic"};
constexpr FloatParam kFov{"fov", "deg", 90, 1e-3f, 179.9f, "field of view of the shorter axis"};
constexpr FloatParam kLensRadius{
    "lensradius", "", 0, 0, kFarthest, "radius of the thin lens; 0: a pinhole"};
constexpr FloatParam kFocalDistance{
    "focaldistance", "", 1e6f, kShortestVector, kLongestVector, "distance of the plane in focus"};
constexpr FloatParam kAspect{
    "frameaspectratio", "", 1, 1e-6f, 1e6f, "width over height; not given: the film's"};
constexpr ArrayParam kScreenWindow{
    "screenwindow", "float", "-1 to 1 along the shorter axis",
    "xmin xmax ymin ymax of what is seen at distance 1 where fov is 90"};
constexpr FloatParam kShutterOpen{"shutteropen", "s", 0, -1e30f, 1e30f, "when the shutter opens"};
constexpr FloatParam kShutterClose{"shutterclose", "s",   1,
                                   -1e30f,         1e30f, "when the shutter closes"};

struct ScreenWindow {
    float x0, x1, y0, y1;
};

ScreenWindow ReadScreenWindow(ParamDict &params, Point2i resolution) {
    FloatParam row = kAspect;
    row.def = float(resolution.x) / resolution.y;
    const float aspect = params.GetOneFloat(row);
    ScreenWindow w = aspect > 1 ? ScreenWindow{-aspect, aspect, -1, 1}
                                : ScreenWindow{-1, 1, -1 / aspect, 1 / aspect};
    const std::vector<float> given = params.GetFloatArray(kScreenWindow);
    if (given.empty()) return w;
    if (given.size() != 4 || given[0] >= given[1] || given[2] >= given[3])
        params.Error(kScreenWindow.name, "\"screenwindow\" needs four values: xmin xmax ymin ymax");
    else
        w = {given[0], given[1], given[2], given[3]};
    return w;
}

struct Spaces {
    Transform renderFromCamera, renderFromWorld;
};

/// Each directly, for a product of one with the other's inverse, both rounded, would skew the world
/// against the camera by 1e-8 of its coordinates.
Spaces ChooseSpaces(const Transform &cameraFromWorld, std::string_view space) {
    if (space == "camera") return {{}, cameraFromWorld};
    const Transform worldFromCamera = cameraFromWorld.Inverse();
    if (space == "world") return {worldFromCamera, {}};
    const Transform fromEye = Transform::Translate(-worldFromCamera.Point({0, 0, 0}));
    return {fromEye * worldFromCamera, fromEye};
}

}  // namespace

bool Camera::SetOrigins(Point2i resolution) {
    const Vector3f lens = lensRadius * (Abs(right) + Abs(up));
    bool safe = HasSafeLength(forward);
    for (int i = 0; i < 4; ++i) {
        const Point2f corner{i & 1 ? float(resolution.x) : 0, i & 2 ? float(resolution.y) : 0};
        const Point3f o = OriginAt(corner);
        const Vector3f d = DirectionAt(corner);
        origins.Grow({o - lens, o + lens});
        safe = safe && HasSafeLength(d);
        if (lensRadius > 0) safe = safe && HasSafeLength((focalDistance / DotAxis(d)) * d);
    }
    return safe && IsInRange(origins);
}

Camera Camera::Create(const SceneDescription &scene, Point2i resolution, Diagnostics &log) {
    const std::string type = scene.camera.type.empty() ? "perspective" : scene.camera.type;
    ParamDict params(scene.camera.params, scene.camera.loc, fmt::format("camera \"{}\"", type),
                     scene.camera.colorSpace, &log, scene.dir);
    return Create(type, params, scene, resolution);
}

std::span<const std::string_view> Camera::Names() {
    return kNames;
}

Camera Camera::Create(std::string_view type, ParamDict &params, const SceneDescription &scene,
                      Point2i resolution) {
    Camera c;
    const bool orthographic = type == kNames[1];
    if (!orthographic && type != kNames[0]) {
        params.Error(UnknownName("camera", type, kNames));
        return c;
    }
    if (!(scene.cameraFromWorld[0] == scene.cameraFromWorld[1]))
        params.Error("moving cameras are not supported");

    const ScreenWindow window = ReadScreenWindow(params, resolution);
    const float fov = orthographic ? 90 : params.GetOneFloat(kFov);
    c.lensRadius = params.GetOneFloat(kLensRadius);
    c.focalDistance = params.GetOneFloat(kFocalDistance);
    c.shutterOpen = params.GetOneFloat(kShutterOpen);
    c.shutterClose = params.GetOneFloat(kShutterClose);
    if (!(c.shutterClose > c.shutterOpen))
        params.Error(kShutterClose.name, "\"shutterclose\" must be later than \"shutteropen\"");
    params.ReportUnused();
    const double start = scene.transformStart, duration = scene.transformEnd - start;
    const auto rayTime = [&](double t) {
        return float(std::clamp((t - start) / std::max(duration, 1e-30), -1e30, 1e30));
    };
    c.timeOpen = rayTime(c.shutterOpen);
    c.timeClose = rayTime(c.shutterClose);

    c.cameraFromWorld = scene.cameraFromWorld[0];
    const Spaces spaces = ChooseSpaces(c.cameraFromWorld, scene.options.renderCoordSys);
    c.renderFromCamera = spaces.renderFromCamera;
    c.renderFromWorld = spaces.renderFromWorld;

    // Film (0, 0) is the screen's upper left corner.
    const float perX = (window.x1 - window.x0) / resolution.x,
                perY = (window.y1 - window.y0) / resolution.y;
    const float scale = orthographic ? 1 : std::tan(Radians(fov) / 2);
    const Vector3f corner{window.x0 * scale, window.y1 * scale, 0};
    const Vector3f stepX{perX * scale, 0, 0}, stepY{0, -perY * scale, 0}, axis{0, 0, 1};
    const auto point = [&](Point3f p) { return c.renderFromCamera.Point(p); };
    const auto vector = [&](Vector3f v) { return c.renderFromCamera.Vector(v); };
    c.origin = point(orthographic ? corner : Point3f{});
    c.direction = vector(orthographic ? axis : corner + axis);
    (orthographic ? c.originPerX : c.directionPerX) = vector(stepX);
    (orthographic ? c.originPerY : c.directionPerY) = vector(stepY);
    c.right = vector({1, 0, 0}), c.up = vector({0, 1, 0});
    // Distance along the axis of a direction: exact also where the camera's transform scales.
    c.forward = vector(axis) / LengthSquared(vector(axis));
    c.downOfFrame = Dot(Cross(c.forward, c.right), c.up) < 0 ? 1 : -1;
    if (!c.SetOrigins(resolution))
        params.Error(fmt::format(
            "camera \"{}\": its transformation, screen window or lens makes rays that cannot be "
            "traced: origins may have coordinates up to {:g}; directions, and distances to what is "
            "in focus, be {:g} to {:g} long",
            type, kFarthest, kShortestVector, kLongestVector));
    c.pixelAngle = orthographic ? 0 : perX * scale;
    c.pixelSize = orthographic ? perX : 0;

    const Transform screen = orthographic ? Transform() : Transform::Perspective(fov, 1e-2f, 1000);
    const Transform ndc =
        Transform::Scale({1 / (window.x1 - window.x0), -1 / (window.y1 - window.y0), 1})
            .value_or(Transform()) *
        Transform::Translate({-window.x0, -window.y1, 0});
    c.ndcFromWorld = ndc * screen * c.cameraFromWorld;
    return c;
}

}  // namespace pbrt
