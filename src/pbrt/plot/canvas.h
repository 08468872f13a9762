#pragma once

#include <cairo.h>

#include <memory>
#include <span>
#include <string>

#include "pbrt/image/image.h"

namespace pbrt::plot {

/// Components in [0, 1], sRGB-encoded.
struct Ink {
    double r = 0, g = 0, b = 0, a = 1;
};
inline constexpr Ink kBlack{}, kGrey{0.55, 0.55, 0.55}, kPale{0.86, 0.86, 0.86};

struct Place {
    double x, y;  ///< pixels, y downwards
};

enum class Align { Left, Center, Right };

/// A white sheet to draw on, by cairo. What cairo fails at, mostly for want of memory, is thrown
/// when the sheet is made or taken, as std::bad_alloc or std::runtime_error.
class Canvas {
  public:
    Canvas(int width, int height);

    void Line(Place from, Place to, Ink ink, double width = 1);
    void Polyline(std::span<const Place> points, Ink ink, double width = 1);
    void Fill(Place corner, Place size, Ink ink);
    void Outline(Place corner, Place size, Ink ink, double width = 1);
    void Circle(Place center, double radius, Ink ink, double width = 1);
    /// `at`: the beginning, middle or end of the base line; `quarterTurns` counterclockwise.
    void Text(Place at, const std::string &text, double size, Align align = Align::Left,
              Ink ink = kBlack, int quarterTurns = 0);
    double TextWidth(const std::string &text, double size);
    /// An image of linear R G B times `exposure`, one pixel to one, cut to its inscribed circle.
    void Disc(Place corner, const Image &image, float exposure);

    /// The sheet as a PNG file's bytes.
    std::string Png() const;

  private:
    struct Release {
        void operator()(cairo_surface_t *s) const { cairo_surface_destroy(s); }
        void operator()(cairo_t *c) const { cairo_destroy(c); }
    };
    using Surface = std::unique_ptr<cairo_surface_t, Release>;
    static Surface MakeSurface(int width, int height);

    void SetInk(Ink ink, double width);

    Surface surface;
    std::unique_ptr<cairo_t, Release> context;
};

}  // namespace pbrt::plot
