#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pbrt/bsdftool/reflectance.h"
#include "pbrt/plot/axis.h"
#include "pbrt/plot/canvas.h"

namespace pbrt::bsdftool {
namespace {

using namespace plot;

constexpr int kWidth = 900, kHeight = 640;
constexpr double kFont = 13, kLeft = 80, kRight = 790, kTop = 56, kBottom = 440;
constexpr double kStripTop = 520, kStripBottom = 580;
// Told apart by people of any color vision (Okabe and Ito 2008).
constexpr std::array<Ink, 7> kInks{{{0, 0.447, 0.698},
                                    {0.902, 0.624, 0},
                                    {0, 0.620, 0.451},
                                    {0.800, 0.475, 0.655},
                                    {0.835, 0.369, 0},
                                    {0.337, 0.706, 0.914},
                                    {0, 0, 0}}};

void DrawGrid(Canvas &canvas, const Axis &x, const Axis &y) {
    for (double t : x.Ticks(9)) {
        canvas.Line({x.At(t), kTop}, {x.At(t), kBottom}, kPale);
        canvas.Text({x.At(t), kBottom + 20}, fmt::format("{:g}", t), kFont, Align::Center);
    }
    for (double t : y.Ticks(6)) {
        canvas.Line({kLeft, y.At(t)}, {kRight, y.At(t)}, kPale);
        canvas.Text({kLeft - 8, y.At(t) + 5}, fmt::format("{:.6g}", t), kFont, Align::Right);
    }
    canvas.Outline({kLeft, kTop}, {kRight - kLeft, kBottom - kTop}, kGrey);
    canvas.Text({(kLeft + kRight) / 2, kBottom + 42}, "wavelength [nm]", kFont, Align::Center);
    canvas.Text({24, (kTop + kBottom) / 2}, "reflectance", kFont, Align::Center, kBlack, 1);
}

void DrawCurves(Canvas &canvas, const ReflectanceTable &table, const Axis &x, const Axis &y) {
    const size_t n = table.angles.size(), curves = std::min(n, kInks.size());
    canvas.Text({kRight + 16, kTop + 14}, "theta", kFont);
    for (size_t k = 0; k < curves; ++k) {
        const auto &angle = table.angles[curves == 1 ? 0 : k * (n - 1) / (curves - 1)];
        std::vector<Place> points;
        for (size_t i = 0; i < table.lambda.size(); ++i)
            points.push_back({x.At(table.lambda[i]), y.At(angle.energy.reflected[i])});
        canvas.Polyline(points, kInks[k], 2);
        const double row = kTop + 36 + 20 * double(k);
        canvas.Line({kRight + 16, row - 5}, {kRight + 40, row - 5}, kInks[k], 3);
        canvas.Text({kRight + 48, row}, fmt::format("{:g}°", angle.theta), kFont);
    }
}

/// One patch per angle, as wide as its share, all times the same factor.
void DrawStrip(Canvas &canvas, const ReflectanceTable &table, const std::string &illuminant) {
    float brightest = 0;
    std::vector<RGB> colors;
    for (const auto &angle : table.angles) {
        colors.push_back(RGBColorSpace::sRGB().ToRGB(angle.color));
        brightest = std::max(brightest, colors.back().Max());
    }
    const float factor = brightest > 0 ? 1 / brightest : 1;
    const double width = (kRight - kLeft) / double(colors.size());
    const ColorEncoding sRGB{ColorEncoding::Kind::sRGB};
    const size_t every = std::max<size_t>(1, (colors.size() + 17) / 18);
    for (size_t i = 0; i < colors.size(); ++i) {
        const auto encoded = [&](int c) {
            return double(sRGB.FromLinear(std::clamp(colors[i][c] * factor, 0.f, 1.f)));
        };
        const double left = kLeft + width * double(i);
        canvas.Fill({left, kStripTop}, {width + 0.5, kStripBottom - kStripTop},
                    {encoded(0), encoded(1), encoded(2)});
        if (i % every == 0)
            canvas.Text({left + width / 2, kStripBottom + 18},
                        fmt::format("{:g}°", table.angles[i].theta), kFont, Align::Center);
    }
    canvas.Outline({kLeft, kStripTop}, {kRight - kLeft, kStripBottom - kStripTop}, kGrey);
    canvas.Text({kLeft, kStripTop - 8},
                fmt::format("sRGB under {}, times {:.3g}", illuminant, factor), kFont);
    canvas.Text({(kLeft + kRight) / 2, kStripBottom + 40}, "theta", kFont, Align::Center);
}

}  // namespace

std::string ReflectanceChart(const ReflectanceTable &table, const std::string &title,
                             const std::string &illuminant) {
    Canvas canvas(kWidth, kHeight);
    double most = 0;
    for (const auto &angle : table.angles)
        for (double r : angle.energy.reflected)
            most = std::max(most, r);
    const Axis x{table.lambda.front(), table.lambda.back(), kLeft, kRight};
    const Axis y{0, most > 0 ? most * 1.05 : 1, kBottom, kTop};
    canvas.Text({kLeft, 32}, title, kFont + 1);
    DrawGrid(canvas, x, y);
    DrawCurves(canvas, table, x, y);
    DrawStrip(canvas, table, illuminant);
    return canvas.Png();
}

}  // namespace pbrt::bsdftool
