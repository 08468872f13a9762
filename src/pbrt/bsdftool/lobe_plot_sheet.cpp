#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "pbrt/bsdftool/lobe_plot.h"
#include "pbrt/plot/axis.h"
#include "pbrt/plot/canvas.h"

namespace pbrt::bsdftool {
namespace {

using namespace plot;

constexpr double kFont = 12, kSmall = 10;
constexpr double kMargin = 60, kTop = 64, kAbove = 26, kBelow = 52, kRight = 24;
constexpr Ink kMark{1, 1, 1, 0.9}, kRing{1, 1, 1, 0.35};

/// One disc with its frame: `corner` is the disc's.
class Panel {
  public:
    Panel(Canvas &canvas, Place corner, double size)
        : canvas(canvas),
          x{-1, 1, corner.x, corner.x + size},
          y{-1, 1, corner.y + size, corner.y},
          corner(corner),
          size(size) {}

    void Picture(const Image &image, float exposure) {
        canvas.Disc(corner, image, exposure);
        const Place middle{x.At(0), y.At(0)};
        for (double theta : {30.0, 60.0}) {
            const double sine = std::sin(theta * std::numbers::pi / 180);
            canvas.Circle(middle, sine * size / 2, kRing);
            canvas.Text({x.At(0) + 3, y.At(sine) - 3}, fmt::format("{}°", theta), kSmall,
                        Align::Left, kMark);
        }
        canvas.Circle(middle, size / 2, kGrey);
    }

    void Axes() {
        const double bottom = corner.y + size;
        for (double t : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const std::string label = fmt::format("{:g}", t);
            canvas.Line({x.At(t), bottom + 4}, {x.At(t), bottom + 9}, kGrey);
            canvas.Text({x.At(t), bottom + 21}, label, kSmall, Align::Center);
            canvas.Line({corner.x - 9, y.At(t)}, {corner.x - 4, y.At(t)}, kGrey);
            canvas.Text({corner.x - 12, y.At(t) + 4}, label, kSmall, Align::Right);
        }
        canvas.Text({x.At(0), bottom + 37}, "x", kFont, Align::Center);
        canvas.Text({corner.x - 42, y.At(0)}, "y", kFont, Align::Center);
    }

    /// A ring: where the light comes from.
    void Ring(const LocalDirection &w) { canvas.Circle({x.At(w.x), y.At(w.y)}, 5, kMark, 1.5); }
    /// A cross: where a mirror, or nothing at all, would send it.
    void Cross(const LocalDirection &w) {
        const Place at{x.At(-w.x), y.At(-w.y)};
        canvas.Line({at.x - 5, at.y}, {at.x + 5, at.y}, kMark, 1.5);
        canvas.Line({at.x, at.y - 5}, {at.x, at.y + 5}, kMark, 1.5);
    }

  private:
    Canvas &canvas;
    Axis x, y;
    Place corner;
    double size;
};

/// The text, cut so that it fits.
std::string Shortened(Canvas &canvas, std::string text, double font, double width) {
    for (char &c : text)
        if (c == '\n' || c == '\t') c = ' ';
    if (canvas.TextWidth(text, font) <= width) return text;
    while (!text.empty() && canvas.TextWidth(text + "...", font) > width)
        text.pop_back();
    return text + "...";
}

void DrawView(Canvas &canvas, const LobePlot &view, double top, double size, float exposure) {
    const LocalDirection light = Spherical(view.light.theta, view.light.phi);
    const double left = kMargin, right = kMargin + size + kMargin;
    Panel own(canvas, {left, top}, size), other(canvas, {right, top}, size);
    own.Picture(view.ownSide, exposure);
    own.Ring(light);
    own.Cross(light);
    own.Axes();
    other.Picture(view.otherSide, exposure);
    other.Cross(light);
    other.Axes();
    canvas.Text({left + size / 2, top - 10},
                fmt::format("reflected; light {:g}°, phi {:g}°", view.light.theta, view.light.phi),
                kFont, Align::Center);
    canvas.Text({right + size / 2, top - 10},
                view.hasGap ? fmt::format("transmitted; straight on {:.3f}", view.gap)
                            : std::string("transmitted"),
                kFont, Align::Center);
}

}  // namespace

std::string ScatterogramSheet(const std::vector<LobePlot> &views, float exposure,
                              const std::string &title, const std::string &quantity) {
    const int n = views.empty() ? 0 : views[0].ownSide.Resolution().x;
    const double row = kAbove + n + kBelow;
    const double width = 2 * (kMargin + n) + kRight;
    Canvas canvas(int(width), int(kTop + row * double(views.size())));
    const double usable = width - kMargin - kRight;
    canvas.Text({kMargin, 24}, Shortened(canvas, title, kFont + 1, usable), kFont + 1);
    const std::string legend =
        fmt::format("{}, times {:.4g}; ring: light; cross: mirrored or passed straight{}", quantity,
                    exposure, !views.empty() && views[0].hasGap ? "; y along the barbules" : "");
    canvas.Text({kMargin, 44}, Shortened(canvas, legend, kSmall + 1, usable), kSmall + 1);
    for (size_t i = 0; i < views.size(); ++i)
        DrawView(canvas, views[i], kTop + row * double(i) + kAbove - 12, n, exposure);
    return canvas.Png();
}

}  // namespace pbrt::bsdftool
