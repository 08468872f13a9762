#include <fmt/format.h>

#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

/// Color as a point in the plane across the gray axis: the angle is the hue, red at 0 degrees.
struct Chroma {
    double x = 0, y = 0;
    double Hue() const { return std::atan2(y, x) * (180 / 3.14159265358979323846); }
};

/// Of the sum of all pixels in columns [x0, x1): gray parts do not count.
Chroma MeanChroma(const Image &rgb, int x0, int x1) {
    Chroma sum;
    for (int y = 0; y < rgb.Resolution().y; ++y)
        for (int x = x0; x < x1; ++x) {
            const float *p = rgb.Pixel({x, y});
            sum.x += p[0] - 0.5 * (double(p[1]) + p[2]);
            sum.y += std::sqrt(0.75) * (double(p[1]) - p[2]);
        }
    return sum;
}

double HueDifference(const Chroma &a, const Chroma &b) {
    const double d = std::abs(a.Hue() - b.Hue());
    return std::min(d, 360 - d);
}

}  // namespace

Outcome Check(Args args) {
    std::string file;
    double least = -1;
    CLI::App app(
        "Tests that every value is finite and that the picture is not black. Exit code 1 "
        "where it fails.",
        "imgtool check");
    app.add_option("picture", file)->required();
    app.add_option("--hue-change", least,
                   "test too that the hues of the left and the right third differ by this many "
                   "degrees at least")
        ->check(CLI::Range(0, 180));
    if (auto end = Parse(&app, args)) return *end;
    const OrError<Image> image = ReadPart(file, {"R", "G", "B"}, {});
    if (!image) return Failure(image.error);
    double sum = 0;
    for (const float v : image.value->Data()) {
        if (!std::isfinite(v))
            return Failure(fmt::format("{}: has values that are not finite", file));
        sum += v;
    }
    const double mean = sum / double(image.value->Data().size());
    if (!(mean > 0)) return Failure(fmt::format("{}: is black", file));
    const int width = image.value->Resolution().x;
    const Chroma left = MeanChroma(*image.value, 0, std::max(1, width / 3));
    const Chroma right = MeanChroma(*image.value, width - std::max(1, width / 3), width);
    const double change = HueDifference(left, right);
    const std::string found =
        fmt::format("hue {:.0f} degrees at the left, {:.0f} at the right", left.Hue(), right.Hue());
    if (change < least)
        return Failure(fmt::format("{}: {}, a change of less than {}", file, found, least));
    return {0, fmt::format("{}: finite, mean {:.6g}, {}\n", file, mean, found), {}};
}

}  // namespace pbrt::imgtool
