#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/util/equal_area.h"

namespace pbrt::imgtool {
namespace {

/// Value of a latitude-longitude image towards d (z up, row 0 at +z, column 0 at +x, turning to
/// +y), bilinear between pixel centres.
void LookUp(const Image &latLong, Vector3f d, double weight, double *sum) {
    const auto [width, height] = latLong.Resolution();
    const float phi = std::atan2(d.y, d.x);
    const float u = (phi < 0 ? phi + 2 * Pi : phi) / (2 * Pi) * width - 0.5f;
    const float v = AngleBetween(d, {0, 0, 1}) / Pi * height - 0.5f;
    const int x = int(std::floor(u)), y = int(std::floor(v));
    for (int i = 0; i < 4; ++i) {
        const int xi = x + (i & 1), yi = y + (i >> 1);
        const float w = (i & 1 ? u - x : 1 - (u - x)) * (i >> 1 ? v - y : 1 - (v - y));
        const float *pixel = latLong.Pixel({(xi + width) % width, std::clamp(yi, 0, height - 1)});
        for (int c = 0; c < latLong.NChannels(); ++c)
            sum[c] += weight * w * pixel[c];
    }
}

Image EqualArea(const Image &latLong, int resolution) {
    Image square({resolution, resolution}, latLong.ChannelNames());
    square.metadata.chromaticities = latLong.metadata.chromaticities;
    // As many look-ups along a pixel's edge as keep input pixels from being stepped over.
    const int n = std::max(1, (latLong.Resolution().x + resolution - 1) / resolution);
    for (int y = 0; y < resolution; ++y)
        for (int x = 0; x < resolution; ++x) {
            std::vector<double> sum(latLong.NChannels());
            for (int i = 0; i < n * n; ++i) {
                const Point2f p{(x + (i % n + 0.5f) / n) / resolution,
                                (y + (i / n + 0.5f) / n) / resolution};
                LookUp(latLong, EqualAreaSquareToSphere(p), 1. / (n * n), sum.data());
            }
            for (int c = 0; c < latLong.NChannels(); ++c)
                square.Set({x, y}, c, float(sum[c]));
        }
    return square;
}

struct Options {
    std::string file, outfile;
    int resolution = 0;
};

constexpr char kDescription[] =
    "Turns a latitude-longitude environment picture (twice as wide as high, z up) into "
    "the square equal-area octahedral one that the infinite light reads.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "latitude-longitude picture");
    AddOutfile(app, &o->outfile);
    cli::AddNumber(app, "--resolution", &o->resolution, {.lo = 1, .hi = 32768},
                   "pixels along the edge (default: the input's width)");
}

Outcome WithOptions(Options &o) {
    std::string remarks;
    const OrError<Image> latLong = Read(o.file, &remarks);
    if (!latLong) return Failure(latLong.error);
    const auto [width, height] = latLong.value->Resolution();
    if (width != 2 * height)
        return Failure(fmt::format("{}: has {} x {} pixels, not twice as many columns as rows",
                                   o.file, width, height));
    return Remarking(remarks,
                     Write(EqualArea(*latLong.value, o.resolution > 0 ? o.resolution : width),
                           o.outfile, ExrPixels::Float));
}

}  // namespace

Outcome MakeEquiArea(Args args) {
    return cli::RunWithOptions(args, "imgtool makeequiarea", kDescription, DefineOptions,
                               WithOptions);
}

}  // namespace pbrt::imgtool
