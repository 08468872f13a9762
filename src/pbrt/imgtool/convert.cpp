#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/image/primaries.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/imgtool/tone.h"
#include "pbrt/spectra/color.h"
#include "pbrt/util/diagnostics.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::string file, outfile, colorSpace;
    std::vector<std::string> channels;
    std::vector<int> crop;
    float clamp = Infinity, despike = Infinity, scale = 1, exposure = 0, gamma = 1;
    float maxLuminance = 1;
    int repeat = 1;
    bool bw = false, tonemap = false, preserveColors = false, acesFilmic = false, flipY = false;
    bool fp16 = false;
};

constexpr char kDescription[] =
    "Changes pictures. What is asked for is done in this order: channels, crop, clamp, "
    "colorspace, bw, despike, scale and exposure, gamma, tonemap, preserve-colors, "
    "aces-filmic, repeat-pix, flipy. Channel A keeps its values.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file,
                     "picture to read (EXR, PNG, JPEG, PFM, HDR, QOI, TGA)");
    AddOutfile(app, &o->outfile);
    AddChannels(app, &o->channels);
    AddCrop(app, &o->crop);
    cli::AddNumber(app, "--clamp", &o->clamp, {}, "largest value");
    cli::AddText(app, "--colorspace", &o->colorSpace, "srgb, rec2020, dci-p3 or aces2065-1");
    cli::AddFlag(app, "--bw", &o->bw, "gray: the mean of the channels");
    cli::AddNumber(app, "--despike", &o->despike, {},
                   "replace pixels of a mean above this by the median of their neighbours");
    cli::AddNumber(app, "--scale", &o->scale, {}, "factor (default 1)");
    cli::AddNumber(app, "--exposure", &o->exposure, {}, "factor 2^x: x stops (default 0)");
    cli::AddNumber(app, "--gamma", &o->gamma, cli::kAboveZero, "exponent (default 1)");
    cli::AddFlag(app, "--tonemap", &o->tonemap, "Reinhard's operator on the mean of the channels");
    cli::AddNumber(app, "--max-luminance", &o->maxLuminance, cli::kAboveZero,
                   "mean that --tonemap takes to 1 (default 1)");
    cli::AddFlag(app, "--preserve-colors", &o->preserveColors,
                 "scale pixels with values above 1 down instead of clipping each value");
    cli::AddFlag(app, "--aces-filmic", &o->acesFilmic, "filmic curve to [0, 1]");
    cli::AddNumber(app, "--repeat-pix", &o->repeat, {.lo = 1, .hi = 1024},
                   "repeat pixels n times in both directions");
    cli::AddFlag(app, "--flipy", &o->flipY, "upside down");
    cli::AddFlag(app, "--fp16", &o->fp16, "half floats in EXR (default: as the input)");
}

std::optional<std::string> ToColorSpace(const std::string &name, Image *image) {
    const RGBColorSpace *space = RGBColorSpace::Named(name);
    if (!space)
        return fmt::format("unknown color space \"{}\"; there are {}", name,
                           QuotedList(RGBColorSpace::Names()));
    const auto matrix =
        RGBFromRGB(space->Chromaticities(),
                   image->metadata.chromaticities.value_or(RGBColorSpace::sRGB().Chromaticities()));
    if (!matrix) return "the picture's chromaticities span no color space";
    if (!TransformRGB(*matrix, image)) return "--colorspace needs the channels R, G and B";
    image->metadata.chromaticities = space->Chromaticities();
    if (SamePrimaries(space->Chromaticities(), kSRGBChromaticities))
        image->metadata.chromaticities.reset();
    return {};
}

Outcome WithOptions(Options &o) {
    std::string remarks;
    OrError<Image> input = ReadPart(o.file, o.channels, o.crop, &remarks);
    if (!input) return Failure(input.error);
    Image image = std::move(*input.value);

    ForEachValue(&image, [&](float v) { return std::min(v, o.clamp); });
    if (!o.colorSpace.empty())
        if (auto reason = ToColorSpace(o.colorSpace, &image)) return Failure(*reason);
    if (o.bw) image = Gray(image);
    if (o.despike < Infinity) image = Despike(image, o.despike);
    const float factor = o.scale * std::exp2(o.exposure);
    if (factor != 1) ForEachValue(&image, [&](float v) { return factor * v; });
    if (o.gamma != 1)
        ForEachValue(&image, [&](float v) { return std::pow(std::max(0.f, v), o.gamma); });
    if (o.tonemap) Reinhard(&image, o.maxLuminance);
    if (o.preserveColors) ScaleIntoGamut(&image);
    if (o.acesFilmic) ForEachValue(&image, AcesFilmic);
    if (o.repeat > 1) image = RepeatPixels(image, o.repeat);
    if (o.flipY) image = FlipY(image);

    const bool half =
        o.fp16 || image.metadata.storedAs == "half" || image.metadata.storedAs == "8-bit";
    return Remarking(remarks, Write(image, o.outfile, half ? ExrPixels::Half : ExrPixels::Float));
}

}  // namespace

Outcome Convert(Args args) {
    return cli::RunWithOptions(args, "imgtool convert", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
