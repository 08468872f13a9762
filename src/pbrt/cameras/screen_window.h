#pragma once

#include "pbrt/scene/params.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// The part of the screen that the film shows, in units of the screen: y up.
struct ScreenWindow {
    float x0, x1, y0, y1;

    /// Reads `screenwindow` or `frameaspectratio`. Without them the shorter axis is [-1, 1].
    static ScreenWindow Read(ParamDict &params, Point2i resolution);
    float PerPixelX(Point2i resolution) const { return (x1 - x0) / resolution.x; }
    float PerPixelY(Point2i resolution) const { return (y1 - y0) / resolution.y; }
    /// The window to [0, 1]^2, y down.
    Transform NDCFromScreen() const;
};

}  // namespace pbrt
