#include "pbrt/render/mse_log.h"

#include <fmt/format.h>

#include "pbrt/image/primaries.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/math.h"

namespace pbrt {
namespace {

/// Why an image of the film's pixels cannot be compared with the reference.
std::optional<std::string> Mismatch(const Image &reference, const Film &film) {
    for (const char *const name : {"R", "G", "B"})
        if (reference.ChannelIndex(name) < 0) return fmt::format("has no channel {}", name);
    const auto [x0, x1, y0, y1] = reference.metadata.pixelBounds;
    const PixelBounds b = film.Bounds();
    if (b.x0 < x0 || b.x1 > x1 || b.y0 < y0 || b.y1 > y1)
        return fmt::format(
            "has the pixels [{}, {}) x [{}, {}), not all of the picture's, [{}, {}) x [{}, {})", x0,
            x1, y0, y1, b.x0, b.x1, b.y0, b.y1);
    if (!SamePrimaries(reference.metadata.chromaticities.value_or(kSRGBChromaticities),
                       film.ColorSpace().Chromaticities()))
        return "has another color space than the film";
    return {};
}

}  // namespace

std::optional<MseLog> MseLog::Create(const Options &options, const Film &film, Diagnostics &log) {
    const std::string &reference = options.mseReferenceImage, &out = options.mseReferenceOut;
    if (reference.empty() != out.empty())
        log.Error({}, fmt::format("\"{}\" is given, so that \"{}\" must be",
                                  out.empty() ? "msereferenceimage" : "msereferenceout",
                                  out.empty() ? "msereferenceout" : "msereferenceimage"));
    if (reference.empty() || out.empty()) return {};
    OrError<Image> image = ReadImage(reference);
    if (!image) {
        log.Error({}, image.error);
        return {};
    }
    if (const auto why = Mismatch(*image.value, film)) {
        log.Error({}, fmt::format("{}: {}", reference, *why));
        return {};
    }
    if (const auto why = WhyNotWritable(out)) {
        log.Error({}, *why);
        return {};
    }
    MseLog mse;
    mse.reference = std::move(*image.value);
    mse.outfile = out;
    return mse;
}

void MseLog::Add(const Image &image, int samplesPerPixel) {
    const int channels[3] = {reference.ChannelIndex("R"), reference.ChannelIndex("G"),
                             reference.ChannelIndex("B")};
    const auto [x0, x1, y0, y1] = image.metadata.pixelBounds;
    const int left = reference.metadata.pixelBounds[0], top = reference.metadata.pixelBounds[2];
    double sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const float *const rgb = image.Pixel({x - x0, y - y0});
            const float *const expected = reference.Pixel({x - left, y - top});
            for (int c = 0; c < 3; ++c)
                sum += Sqr(double(rgb[c]) - expected[channels[c]]);
        }
    error = sum / (3.0 * (x1 - x0) * (y1 - y0));
    lines += fmt::format("{}, {:.9g}\n", samplesPerPixel, error);
    if (!problem) problem = WriteFileAtomically(outfile, lines);
}

}  // namespace pbrt
