#include "pbrt/plot/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <numbers>
#include <stdexcept>

namespace pbrt::plot {
namespace {

/// cairo goes on after a failure, drawing nothing.
void Check(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

cairo_status_t Append(void *to, const unsigned char *data, unsigned int length) {
    try {
        static_cast<std::string *>(to)->append(reinterpret_cast<const char *>(data), length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc &) {  // which must not pass through C
        return CAIRO_STATUS_NO_MEMORY;
    }
}

}  // namespace

Canvas::Surface Canvas::MakeSurface(int width, int height) {
    Surface made(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    Check(cairo_surface_status(made.get()));
    return made;
}

Canvas::Canvas(int width, int height)
    : surface(MakeSurface(width, height)), context(cairo_create(surface.get())) {
    cairo_select_font_face(context.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
}

void Canvas::SetInk(Ink ink, double width) {
    cairo_set_source_rgba(context.get(), ink.r, ink.g, ink.b, ink.a);
    cairo_set_line_width(context.get(), width);
}

void Canvas::Line(Place from, Place to, Ink ink, double width) {
    const Place points[] = {from, to};
    Polyline(points, ink, width);
}

void Canvas::Polyline(std::span<const Place> points, Ink ink, double width) {
    SetInk(ink, width);
    cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_new_path(context.get());  // text leaves a point behind
    for (const Place &p : points)
        cairo_line_to(context.get(), p.x, p.y);
    cairo_stroke(context.get());
}

void Canvas::Fill(Place corner, Place size, Ink ink) {
    SetInk(ink, 1);
    cairo_rectangle(context.get(), corner.x, corner.y, size.x, size.y);
    cairo_fill(context.get());
}

void Canvas::Outline(Place corner, Place size, Ink ink, double width) {
    SetInk(ink, width);
    cairo_rectangle(context.get(), corner.x, corner.y, size.x, size.y);
    cairo_stroke(context.get());
}

void Canvas::Circle(Place center, double radius, Ink ink, double width) {
    SetInk(ink, width);
    cairo_new_path(context.get());
    cairo_arc(context.get(), center.x, center.y, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(context.get());
}

double Canvas::TextWidth(const std::string &text, double size) {
    cairo_set_font_size(context.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(context.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::Text(Place at, const std::string &text, double size, Align align, Ink ink,
                  int quarterTurns) {
    const double width = TextWidth(text, size);
    const double shift = align == Align::Left ? 0 : align == Align::Center ? width / 2 : width;
    SetInk(ink, 1);
    cairo_save(context.get());
    cairo_translate(context.get(), at.x, at.y);
    cairo_rotate(context.get(), -quarterTurns * std::numbers::pi / 2);
    cairo_move_to(context.get(), -shift, 0);
    cairo_show_text(context.get(), text.c_str());
    cairo_restore(context.get());
}

void Canvas::Disc(Place corner, const Image &image, float exposure) {
    const auto [width, height] = image.Resolution();
    const Surface picture = MakeSurface(width, height);
    unsigned char *bytes = cairo_image_surface_get_data(picture.get());
    const int stride = cairo_image_surface_get_stride(picture.get());
    const ColorEncoding sRGB{ColorEncoding::Kind::sRGB};
    const auto encoded = [&](float linear) {
        return uint32_t(std::lround(255 * sRGB.FromLinear(std::clamp(linear, 0.f, 1.f))));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float *rgb = image.Pixel({x, y});
            uint32_t pixel = 0;
            for (int c = 0; c < 3; ++c)
                pixel = pixel << 8 | encoded(rgb[c] * exposure);
            std::copy_n(reinterpret_cast<const unsigned char *>(&pixel), 4,
                        bytes + y * stride + 4 * x);
        }
    cairo_surface_mark_dirty(picture.get());
    cairo_save(context.get());
    cairo_new_path(context.get());
    cairo_arc(context.get(), corner.x + width / 2.0, corner.y + height / 2.0,
              std::min(width, height) / 2.0, 0, 2 * std::numbers::pi);
    cairo_clip(context.get());
    cairo_set_source_surface(context.get(), picture.get(), corner.x, corner.y);
    cairo_paint(context.get());
    cairo_restore(context.get());
}

std::string Canvas::Png() const {
    Check(cairo_status(context.get()));
    std::string bytes;
    Check(cairo_surface_write_to_png_stream(surface.get(), Append, &bytes));
    return bytes;
}

}  // namespace pbrt::plot
