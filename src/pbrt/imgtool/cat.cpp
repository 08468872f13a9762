#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/imgtool/tone.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::vector<std::string> files, channels;
    std::vector<int> crop, pixel;
    bool csv = false, list = false, sort = false;
};

constexpr char kDescription[] =
    "Prints the values of pixels, one pixel a line: \"(x, y): R,G,B\". x and y count from the "
    "upper "
    "left pixel of the full picture.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "pictures", &o->files, "pictures to print");
    AddChannels(app, &o->channels);
    AddCrop(app, &o->crop);
    cli::AddNumbers(app, "--pixel", &o->pixel, "x,y", {.lo = 0, .hi = 1 << 24},
                    "this pixel of the full picture only");
    cli::AddFlag(app, "--csv", &o->csv, "a row of pixels a line, values between commas");
    cli::AddFlag(app, "--list", &o->list, "nested lists in braces: rows of pixels of values");
    cli::AddFlag(app, "--sort", &o->sort, "by the mean of their channels, the darkest first");
}

std::string Values(const float *pixel, int n) {
    std::string text;
    for (int c = 0; c < n; ++c)
        text += fmt::format("{}{}", c > 0 ? "," : "", pixel[c]);
    return text;
}

/// Rows of pixels; `open` and `close` stand around a pixel's values, `between` after it.
std::string Rows(const Image &image, std::string_view open, std::string_view close,
                 std::string_view rowOpen, std::string_view rowClose) {
    std::string text;
    const auto [width, height] = image.Resolution();
    for (int y = 0; y < height; ++y) {
        text += rowOpen;
        for (int x = 0; x < width; ++x)
            text += fmt::format("{}{}{}{}", open, Values(image.Pixel({x, y}), image.NChannels()),
                                close, x + 1 < width ? "," : "");
        text += y + 1 < height || rowOpen.empty() ? rowClose : rowClose.substr(0, 1);
    }
    return text;
}

/// Indices of the pixels, row by row or from dark to bright.
std::vector<size_t> Order(const Image &image, bool sort) {
    const int n = image.NChannels(), alpha = image.ChannelIndex("A");
    std::vector<size_t> order(image.Data().size() / size_t(n));
    std::iota(order.begin(), order.end(), size_t(0));
    if (!sort) return order;
    const auto mean = [&](size_t i) { return MeanValue(&image.Data()[i * n], n, alpha); };
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return mean(a) < mean(b); });
    return order;
}

std::string Lines(const Image &image, bool sort) {
    const int n = image.NChannels(), width = image.Resolution().x;
    const auto &bounds = image.metadata.pixelBounds;
    std::string text;
    for (const size_t i : Order(image, sort))
        text += fmt::format("({}, {}): {}\n", bounds[0] + int(i % width),
                            bounds[2] + int(i / width), Values(&image.Data()[i * n], n));
    return text;
}

/// The pixel (x, y) of the full picture, or why it is not stored.
OrError<Image> OnePixel(const Image &image, const std::vector<int> &pixel) {
    const auto &b = image.metadata.pixelBounds;
    const int x = pixel[0] - b[0], y = pixel[1] - b[2];
    const auto [width, height] = image.Resolution();
    if (x < 0 || y < 0 || x >= width || y >= height)
        return {{},
                fmt::format("has the pixels [{}, {}) x [{}, {}), not ({}, {})", b[0], b[0] + width,
                            b[2], b[2] + height, pixel[0], pixel[1])};
    return Crop(image, {x, x + 1, y, y + 1});
}

Outcome WithOptions(Options &o) {
    if (int(o.csv) + int(o.list) + int(o.sort) > 1)
        return Failure("--csv, --list and --sort exclude one another");
    std::string remarks, text;
    for (const std::string &file : o.files) {
        OrError<Image> image = ReadPart(file, o.channels, o.crop, &remarks);
        if (!image) return Failure(image.error);
        if (!o.pixel.empty()) {
            image = OnePixel(*image.value, o.pixel);
            if (!image) return Failure(fmt::format("{}: {}", file, image.error));
        }
        if (o.csv)
            text += Rows(*image.value, "", "", "", "\n");
        else if (o.list)
            text += fmt::format("{{{}}}\n", Rows(*image.value, "{", "}", "{", "},\n"));
        else
            text += Lines(*image.value, o.sort);
    }
    return Remarking(remarks, {0, text, {}});
}

}  // namespace

Outcome Cat(Args args) {
    return cli::RunWithOptions(args, "imgtool cat", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
