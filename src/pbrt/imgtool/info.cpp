#include <fmt/format.h>

#include <limits>

#include "pbrt/cli/options.h"
#include "pbrt/image/primaries.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/spectra/color.h"

namespace pbrt::imgtool {
namespace {

std::string ColorSpaceName(const Image &image) {
    const std::optional<Chromaticities> &xy = image.metadata.chromaticities;
    if (!xy) return "sRGB (the file names none)";
    if (const RGBColorSpace *const space = ColorSpaceOf(image)) return std::string(space->Name());
    const auto &c = *xy;
    return fmt::format("R ({}, {}), G ({}, {}), B ({}, {}), white ({}, {})", c[0][0], c[0][1],
                       c[1][0], c[1][1], c[2][0], c[2][1], c[3][0], c[3][1]);
}

std::string MatrixText(std::string_view name,
                       const std::optional<std::array<std::array<float, 4>, 4>> &m) {
    if (!m) return {};
    std::string text = fmt::format("  {}\n", name);
    for (const auto &row : *m)
        text += fmt::format("    {:12.6g} {:12.6g} {:12.6g} {:12.6g}\n", row[0], row[1], row[2],
                            row[3]);
    return text;
}

/// Range and mean of the finite values.
std::string ChannelText(const Image &image, int channel) {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    double sum = 0;
    size_t finite = 0, infinite = 0, nan = 0;
    for (size_t i = channel; i < image.Data().size(); i += image.NChannels()) {
        const float v = image.Data()[i];
        if (std::isnan(v)) {
            ++nan;
        } else if (std::isinf(v)) {
            ++infinite;
        } else {
            ++finite;
            sum += v;
            low = std::min(low, v);
            high = std::max(high, v);
        }
    }
    return fmt::format("  {:<14} {:12.6g} {:12.6g} {:12.6g} {:8} {:8}\n",
                       image.ChannelNames()[channel], low, high, sum / double(finite), infinite,
                       nan);
}

std::string Text(const std::string &file, const Image &image) {
    const ImageMetadata &m = image.metadata;
    const auto [x0, x1, y0, y1] = m.pixelBounds;
    std::string text = fmt::format("{}: {} x {} pixels, {}\n", file, image.Resolution().x,
                                   image.Resolution().y, m.storedAs);
    text += fmt::format("  pixels [{}, {}) x [{}, {}) of {} x {}\n", x0, x1, y0, y1,
                        m.fullResolution.x, m.fullResolution.y);
    text += fmt::format("  color space {}\n", ColorSpaceName(image));
    if (m.renderTimeSeconds) text += fmt::format("  render time {} s\n", *m.renderTimeSeconds);
    if (m.samplesPerPixel) text += fmt::format("  samples per pixel {}\n", *m.samplesPerPixel);
    if (m.mse) text += fmt::format("  MSE {}\n", *m.mse);
    for (const auto &[name, value] : m.strings)
        text += fmt::format("  {}: {}\n", name, value);
    text += MatrixText("camera from world", m.cameraFromWorld);
    text += MatrixText("NDC from world", m.ndcFromWorld);
    text += fmt::format("  {:<14} {:>12} {:>12} {:>12} {:>8} {:>8}\n", "channel", "min", "max",
                        "average", "infinite", "NaN");
    for (int c = 0; c < image.NChannels(); ++c)
        text += ChannelText(image, c);
    return text;
}

struct Options {
    std::vector<std::string> files;
};

constexpr char kDescription[] =
    "Prints size, metadata and the range of each channel; PNG and JPEG as decoded to "
    "linear values.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->files, "pictures");
}

Outcome WithOptions(Options &o) {
    Outcome outcome;
    for (const std::string &file : o.files) {
        const OrError<Image> image = Read(file, &outcome.err);
        if (image) {
            outcome.out += Text(file, *image.value);
        } else {
            outcome.err += fmt::format("imgtool: {}\n", image.error);
            outcome.exitCode = 1;
        }
    }
    return outcome;
}

}  // namespace

Outcome Info(Args args) {
    return cli::RunWithOptions(args, "imgtool info", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
