#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

constexpr int kStrips = 8;

/// Hue of the columns [x0, x1) together, in degrees from red; nullopt where they are nearly gray.
std::optional<double> StripHue(const Image &rgb, int x0, int x1) {
    double gray = 0, x = 0, y = 0;  // the plane across the gray axis, to which grays add nothing
    for (int row = 0; row < rgb.Resolution().y; ++row)
        for (int column = x0; column < x1; ++column) {
            const float *p = rgb.Pixel({column, row});
            gray += (double(p[0]) + p[1] + p[2]) / 3;
            x += p[0] - 0.5 * (double(p[1]) + p[2]);
            y += std::sqrt(0.75) * (double(p[1]) - p[2]);
        }
    if (std::hypot(x, y) < 0.05 * gray) return {};
    return std::atan2(y, x) * (180 / 3.14159265358979323846);
}

/// Largest difference of hue, in degrees, between two of the strips from left to right.
double HueChange(const Image &rgb) {
    const int width = rgb.Resolution().x, strips = std::min(kStrips, width);
    std::vector<double> hues;
    for (int i = 0; i < strips; ++i)
        if (auto hue = StripHue(rgb, i * width / strips, (i + 1) * width / strips))
            hues.push_back(*hue);
    double largest = 0;
    for (const double a : hues)
        for (const double b : hues)
            largest = std::max(largest, std::min(std::abs(a - b), 360 - std::abs(a - b)));
    return largest;
}

struct Options {
    std::string file;
    double least = -1;
};

constexpr char kDescription[] =
    "Tests that every value is finite and that the picture is not black. Exit code 1 "
    "where it fails.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "picture to test");
    cli::AddNumber(app, "--hue-change", &o->least, {.lo = 0, .hi = 180},
                   "test too that the hues of two of eight upright strips differ by this many "
                   "degrees at least");
}

Outcome WithOptions(Options &o) {
    std::string remarks;
    const OrError<Image> image = ReadPart(o.file, {"R", "G", "B"}, {}, &remarks);
    if (!image) return Failure(image.error);
    double sum = 0;
    for (const float v : image.value->Data()) {
        if (!std::isfinite(v))
            return Failure(fmt::format("{}: has values that are not finite", o.file));
        sum += v;
    }
    const double mean = sum / double(image.value->Data().size());
    if (!(mean > 0)) return Failure(fmt::format("{}: is black", o.file));
    const double change = HueChange(*image.value);
    if (change < o.least)
        return Failure(fmt::format("{}: its hue changes by {:.0f} degrees, less than {:g}", o.file,
                                   change, o.least));
    return {0,
            fmt::format("{}: finite, mean {:.6g}, hue changes by {:.0f} degrees\n", o.file, mean,
                        change),
            remarks};
}

}  // namespace

Outcome Check(Args args) {
    return cli::RunWithOptions(args, "imgtool check", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
