#include "pbrt/cameras/perspective.h"

#include "pbrt/cameras/screen_window.h"

namespace pbrt {
namespace {

constexpr FloatParam kFov{"fov", "deg", 90, 1e-3f, 179.9f, "field of view of the shorter axis"};

}  // namespace

PerspectiveCamera PerspectiveCamera::Create(ParamDict &params, const CameraContext &context) {
    PerspectiveCamera c;
    const ScreenWindow window = ScreenWindow::Read(params, context.resolution);
    const float fov = params.GetOneFloat(kFov), scale = std::tan(Radians(fov) / 2);
    const float perX = window.PerPixelX(context.resolution),
                perY = window.PerPixelY(context.resolution);
    // The plane at distance 1, from the screen's upper left corner on.
    const Vector3f corner{window.x0 * scale, window.y1 * scale, 0};
    c.rays = ThinLensRays::Create(
        params, context, {},
        {corner + Vector3f{0, 0, 1}, {perX * scale, 0, 0}, {0, -perY * scale, 0}});
    c.pixelAngle = perX * scale;
    c.ndcFromCamera = window.NDCFromScreen() * Transform::Perspective(fov, 1e-2f, 1000);
    return c;
}

}  // namespace pbrt
