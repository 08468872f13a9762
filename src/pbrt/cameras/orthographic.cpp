#include "pbrt/cameras/orthographic.h"

#include "pbrt/cameras/screen_window.h"

namespace pbrt {

OrthographicCamera OrthographicCamera::Create(ParamDict &params, const CameraContext &context) {
    OrthographicCamera c;
    const ScreenWindow window = ScreenWindow::Read(params, context.resolution);
    const float perX = window.PerPixelX(context.resolution),
                perY = window.PerPixelY(context.resolution);
    // From the screen's upper left corner on.
    c.rays = ThinLensRays::Create(params, context,
                                  {{window.x0, window.y1, 0}, {perX, 0, 0}, {0, -perY, 0}},
                                  {{0, 0, 1}, {}, {}});
    c.pixelSize = perX;
    c.ndcFromCamera = window.NDCFromScreen();
    return c;
}

}  // namespace pbrt
