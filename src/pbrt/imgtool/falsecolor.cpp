#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/color_map.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/imgtool/tone.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::string file, outfile;
    std::vector<std::string> channels;
    std::vector<int> crop;
    float maxValue = 0;
    bool plusMinus = false, ramp = false;
};

constexpr char kDescription[] =
    "Colors pixels by the mean of their channels, from 0 to the largest: dark blue, green, yellow "
    "(viridis).";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddText(app, "picture", &o->file, "picture to color");
    AddOutfile(app, &o->outfile);
    AddChannels(app, &o->channels);
    AddCrop(app, &o->crop);
    cli::AddNumber(app, "--maxvalue", &o->maxValue, cli::kAboveZero,
                   "value of the last color (default: the picture's largest)");
    cli::AddFlag(app, "--plusminus", &o->plusMinus, "values above 0 green, values below 0 red");
    cli::AddFlag(app, "--ramp", &o->ramp, "write the colors from first to last instead");
}

/// Linear values, as images have them.
void SetColor(Image *image, Point2i p, const std::array<float, 3> &sRGB) {
    for (int c = 0; c < 3; ++c)
        image->Set(p, c, ColorEncoding{ColorEncoding::Kind::sRGB}.ToLinear(sRGB[size_t(c)]));
}

Image Ramp() {
    constexpr int kWidth = 512, kHeight = 32;
    Image ramp({kWidth, kHeight}, {"R", "G", "B"});
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            SetColor(&ramp, {x, y}, Viridis(float(x) / (kWidth - 1)));
    return ramp;
}

Image Colored(const Image &image, const Options &o) {
    const int n = image.NChannels(), alpha = image.ChannelIndex("A");
    const auto value = [&](Point2i p) { return MeanValue(image.Pixel(p), n, alpha); };
    const auto [width, height] = image.Resolution();
    float most = o.maxValue;
    if (most == 0)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float v = o.plusMinus ? std::abs(value({x, y})) : value({x, y});
                if (std::isfinite(v)) most = std::max(most, v);
            }
    if (most == 0) most = 1;
    Image colored(image.Resolution(), {"R", "G", "B"});
    colored.metadata = image.metadata;
    colored.metadata.chromaticities.reset();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float v = value({x, y}) / most;
            if (o.plusMinus)
                SetColor(&colored, {x, y},
                         {std::clamp(-v, 0.f, 1.f), std::clamp(v, 0.f, 1.f), 0.f});
            else
                SetColor(&colored, {x, y}, Viridis(v));
        }
    return colored;
}

Outcome WithOptions(Options &o) {
    if (o.ramp) return Write(Ramp(), o.outfile, ExrPixels::Half);
    if (o.file.empty()) return Failure("falsecolor needs a picture, or --ramp");
    std::string remarks;
    const OrError<Image> image = ReadPart(o.file, o.channels, o.crop, &remarks);
    if (!image) return Failure(image.error);
    return Remarking(remarks, Write(Colored(*image.value, o), o.outfile, ExrPixels::Half));
}

}  // namespace

Outcome FalseColor(Args args) {
    return cli::RunWithOptions(args, "imgtool falsecolor", kDescription, DefineOptions,
                               WithOptions);
}

}  // namespace pbrt::imgtool
