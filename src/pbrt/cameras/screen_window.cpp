#include "pbrt/cameras/screen_window.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr FloatParam kAspect{
    "frameaspectratio", "", 1, 1e-6f, 1e6f, "width over height; not given: the film's"};
constexpr ArrayParam kScreenWindow{"screenwindow", "float", "-1 to 1 along the shorter axis",
                                   "xmin xmax ymin ymax of what is seen at distance 1 by fov 90"};

}  // namespace

ScreenWindow ScreenWindow::Read(ParamDict &params, Point2i resolution) {
    FloatParam row = kAspect;
    row.def = float(resolution.x) / resolution.y;
    const float aspect = params.GetOneFloat(row);
    ScreenWindow w = aspect > 1 ? ScreenWindow{-aspect, aspect, -1, 1}
                                : ScreenWindow{-1, 1, -1 / aspect, 1 / aspect};
    const std::vector<float> given = params.GetFloatArray(kScreenWindow);
    if (given.empty()) return w;
    if (given.size() != 4)
        params.Warning(kScreenWindow.name,
                       fmt::format("\"screenwindow\" has no effect, as in pbrt-v4: it needs four "
                                   "values, xmin xmax ymin ymax; found {}",
                                   fmt::join(given, " ")));
    else if (given[0] >= given[1] || given[2] >= given[3])
        params.Error(kScreenWindow.name,
                     fmt::format("\"screenwindow\" needs four values: xmin xmax ymin ymax, xmin < "
                                 "xmax and ymin < ymax; found {}",
                                 fmt::join(given, " ")));
    else
        w = {given[0], given[1], given[2], given[3]};
    return w;
}

Transform ScreenWindow::NDCFromScreen() const {
    return Transform::Scale({1 / (x1 - x0), -1 / (y1 - y0), 1}).value_or(Transform()) *
           Transform::Translate({-x0, -y1, 0});
}

}  // namespace pbrt
