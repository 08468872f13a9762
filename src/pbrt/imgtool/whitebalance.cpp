#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/spectra/color.h"
#include "pbrt/spectra/spectrum.h"
#include "pbrt/util/diagnostics.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::string file, outfile, illuminant;
    std::vector<float> primaries;
    float temperature = 0;
};

constexpr char kDescription[] =
    "Makes what was white under an illuminant white: XYZ is adapted from that white to the one of "
    "the picture's color space, by Bradford's method. Give one of --illuminant, --primaries and "
    "--temperature.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "picture with the channels R, G and B");
    AddOutfile(app, &o->outfile);
    cli::AddText(app, "--illuminant", &o->illuminant, "standard illuminant: A, D50, D65, F1 ...");
    cli::AddNumbers(app, "--primaries", &o->primaries, "x,y", {.lo = 0, .hi = 1, .above = true},
                    "CIE xy of the white");
    cli::AddNumber(app, "--temperature", &o->temperature, {.lo = 4000, .hi = 25000},
                   "daylight of this color temperature, in K");
}

using Chromaticity = std::array<float, 2>;

OrError<Chromaticity> White(const Options &o) {
    if (int(!o.illuminant.empty()) + int(!o.primaries.empty()) + int(o.temperature > 0) != 1)
        return {{}, "give one of --illuminant, --primaries and --temperature"};
    if (!o.primaries.empty()) return {Chromaticity{o.primaries[0], o.primaries[1]}, {}};
    if (o.temperature > 0) {
        const std::array<double, 2> xy = DaylightChromaticity(o.temperature);
        return {Chromaticity{float(xy[0]), float(xy[1])}, {}};
    }
    const Spectrum *const illuminant = GetNamedSpectrum(fmt::format("stdillum-{}", o.illuminant));
    if (!illuminant) {
        constexpr std::string_view kPrefix = "stdillum-";
        std::vector<std::string_view> names;
        for (std::string_view name : NamedSpectrumNames())
            if (name.starts_with(kPrefix)) names.push_back(name.substr(kPrefix.size()));
        return {{},
                fmt::format("unknown illuminant \"{}\"; there are {}", o.illuminant,
                            QuotedList(names))};
    }
    const XYZ c = SpectrumToXYZ(*illuminant);
    const float sum = c.X + c.Y + c.Z;
    return {Chromaticity{c.X / sum, c.Y / sum}, {}};
}

Outcome WithOptions(Options &o) {
    const OrError<Chromaticity> white = White(o);
    if (!white) return Failure(white.error);
    std::string remarks;
    OrError<Image> read = Read(o.file, &remarks);
    if (!read) return Failure(read.error);
    Image &image = *read.value;
    const RGBColorSpace *const space = ColorSpaceOf(image);
    if (!space)
        return Failure(
            fmt::format("{}: has a color space of its own; convert it with \"imgtool "
                        "convert --colorspace\" first",
                        o.file));
    const Matrix3 rgbFromRGB = Product(
        Product(space->RGBFromXYZ(), WhiteBalance(*white.value, space->Chromaticities()[3])),
        space->XYZFromRGB());
    if (!TransformRGB(rgbFromRGB, &image))
        return Failure(fmt::format("{}: has not the channels R, G and B", o.file));
    return Remarking(remarks, Write(image, o.outfile, ExrPixels::Float));
}

}  // namespace

Outcome WhiteBalanced(Args args) {
    return cli::RunWithOptions(args, "imgtool whitebalance", kDescription, DefineOptions,
                               WithOptions);
}

}  // namespace pbrt::imgtool
