#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/flip.h"
#include "pbrt/imgtool/metric.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/imgtool/tile_scores.h"

namespace pbrt::imgtool {
namespace {

constexpr double kSignificance = 0.01;

struct Options {
    std::string file, reference, metric = "MSE", outfile, variance;
    std::vector<std::string> channels;
    std::vector<int> crop;
    double tolerance = 0, varianceRatio = -1;
    int tile = 10;
};

constexpr char kDescription[] =
    "Compares a picture with a reference. Silent, exit code 0: the error is 0 or at "
    "most --difftol. With --variance the tiles are tested instead: exit code 0 where "
    "no tile differs by more than noise explains.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "picture to judge");
    AddComparison(app, &o->reference, &o->metric, "MSE (default), MAE, MRSE or FLIP");
    cli::AddNumber(app, "--difftol", &o->tolerance, cli::kFromZero,
                   "largest error that passes (default 0)");
    cli::AddText(app, "--outfile", &o->outfile, "picture of the error of each value");
    cli::AddText(app, "--variance", &o->variance,
                 "picture of the variance of each reference value");
    cli::AddNumber(app, "--variance-ratio", &o->varianceRatio, cli::kFromZero,
                   "variance of the picture in units of the reference's (default: by the samples "
                   "per pixel in the files, else 1)");
    cli::AddNumber(app, "--tile", &o->tile, {.lo = 1, .hi = 1 << 16},
                   "pixels along a tile's edge (default 10)");
    AddChannels(app, &o->channels);
    AddCrop(app, &o->crop);
}

/// Chooses R, G and B where none are named, if both images have them.
void ChooseChannels(const Image &a, const Image &b, std::vector<std::string> *channels) {
    const std::vector<std::string> rgb{"R", "G", "B"};
    for (const std::string &name : rgb)
        if (a.ChannelIndex(name) < 0 || b.ChannelIndex(name) < 0) return;
    if (channels->empty()) *channels = rgb;
}

double VarianceRatio(const Options &o, const Image &image, const Image &reference) {
    if (o.varianceRatio >= 0) return o.varianceRatio;
    const auto &samples = image.metadata.samplesPerPixel;
    const auto &referenceSamples = reference.metadata.samplesPerPixel;
    if (!samples || !referenceSamples || *samples <= 0) return 1;
    return double(*referenceSamples) / *samples;
}

Outcome TestTiles(const Options &o, const Image &image, const Image &reference,
                  std::string *remarks) {
    const OrError<Image> variance = ReadPart(o.variance, image.ChannelNames(), o.crop, remarks);
    if (!variance) return Failure(variance.error);
    if (variance.value->Resolution() != image.Resolution())
        return Failure(fmt::format("{}: has not the size of the pictures", o.variance));
    const double ratio = VarianceRatio(o, image, reference);
    const TileScores test =
        CompareTiles(image, reference, *variance.value, ratio, o.tile, kSignificance);
    return {test.beyond > 0 ? 1 : 0,
            fmt::format("{} of {} z-scores ({} x {} tiles, {} channels) beyond +-{:.3f}\n"
                        "mean z {:.4f}, rms z {:.4f}, largest z {:.3f} in the tile at ({}, {})\n",
                        test.beyond, test.scores, o.tile, o.tile, image.NChannels(), test.bound,
                        test.meanZ, test.rmsZ, test.worstZ, test.worstTile.x, test.worstTile.y),
            {}};
}

/// The error of the picture and its mean; `metric`: null for FLIP.
double ErrorOf(const Metric *metric, const Image &image, const Image &reference, Image *picture) {
    if (metric) return MeanError(*metric, image, reference, picture);
    *picture = Flip(image, reference);
    picture->metadata = image.metadata;
    return AverageValue(*picture);
}

Outcome Compare(Options o, const Metric *metric, std::string *remarks) {
    OrError<Image> image = ReadPart(o.file, o.channels, o.crop, remarks);
    OrError<Image> reference = ReadPart(o.reference, o.channels, o.crop, remarks);
    if (!image || !reference) return Failure(image ? reference.error : image.error);
    if (o.channels.empty()) {
        ChooseChannels(*image.value, *reference.value, &o.channels);
        if (!o.channels.empty()) {
            image = SelectChannels(*image.value, o.channels);
            reference = SelectChannels(*reference.value, o.channels);
        }
    }
    if (auto mismatch = Mismatch(*image.value, *reference.value)) return Failure(*mismatch);

    if (!metric && (image.value->ChannelNames() != std::vector<std::string>{"R", "G", "B"}))
        return Failure("FLIP needs the channels R, G and B");

    Image picture;
    const double error = ErrorOf(metric, *image.value, *reference.value, &picture);
    if (!o.outfile.empty()) {
        const Outcome written = Write(picture, o.outfile, ExrPixels::Float);
        if (written.exitCode != 0) return written;
    }
    if (!o.variance.empty()) return TestTiles(o, *image.value, *reference.value, remarks);
    if (error <= o.tolerance) return {};
    const double a = AverageValue(*image.value), b = AverageValue(*reference.value);
    return {
        1,
        fmt::format("{}: average {:.6g}\n{}: average {:.6g}\ndelta {:+.4f} %, {} {:.6g}\n", o.file,
                    a, o.reference, b, 100 * (a - b) / b, metric ? metric->name : "FLIP", error),
        {}};
}

Outcome WithOptions(Options &o) {
    const Metric *metric = MetricNamed(o.metric);
    if (!metric && !IsFlip(o.metric)) return Failure(UnknownMetric(o.metric, {"FLIP"}));
    std::string remarks;
    const Outcome outcome = Compare(std::move(o), metric, &remarks);
    return Remarking(remarks, outcome);
}

}  // namespace

Outcome Diff(Args args) {
    return cli::RunWithOptions(args, "imgtool diff", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
