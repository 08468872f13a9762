#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/metric.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::vector<std::string> files;
    std::string reference, metric = "MSE", errorFile;
    std::vector<int> crop;
};

constexpr char kDescription[] =
    "Estimates the error of one rendering from several that differ in their seeds: the "
    "sum of their errors divided by their number less one. All must have the same "
    "number of samples per pixel.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->files, "pictures, or the beginning of their names");
    AddComparison(app, &o->reference, &o->metric);
    cli::AddText(app, "--errorfile", &o->errorFile, "picture of the error of each value");
    AddCrop(app, &o->crop);
}

Outcome WithOptions(Options &o) {
    const Metric *metric = MetricNamed(o.metric);
    if (!metric) return Failure(UnknownMetric(o.metric));
    const OrError<std::vector<std::string>> files = FilesOf(o.files);
    if (!files) return Failure(files.error);
    const size_t n = files.value->size();
    if (n < 2) return Failure("error needs two pictures at least");
    std::string remarks;
    const OrError<Image> reference = ReadPart(o.reference, {}, o.crop, &remarks);
    if (!reference) return Failure(reference.error);

    double sum = 0;
    std::optional<Image> total;
    std::optional<int> samples;
    for (const std::string &file : *files.value) {
        const OrError<Image> image =
            ReadPart(file, reference.value->ChannelNames(), o.crop, &remarks);
        if (!image) return Failure(image.error);
        if (auto mismatch = Mismatch(*image.value, *reference.value))
            return Failure(fmt::format("{}: {}", file, *mismatch));
        if (total && image.value->metadata.samplesPerPixel != samples)
            return Failure(fmt::format("{}: has another number of samples per pixel", file));
        samples = image.value->metadata.samplesPerPixel;
        Image errors;
        sum += MeanError(*metric, *image.value, *reference.value, &errors);
        if (!total)
            total = std::move(errors);
        else
            for (size_t i = 0; i < errors.Data().size(); ++i)
                total->Data()[i] += errors.Data()[i];
    }
    for (float &v : total->Data())
        v /= float(n - 1);
    if (!o.errorFile.empty()) {
        const Outcome written = Write(*total, o.errorFile, ExrPixels::Float);
        if (written.exitCode != 0) return written;
    }
    const std::string perPixel =
        samples ? fmt::format(" of {} samples per pixel", *samples) : std::string();
    return {0,
            fmt::format("{} {:.6g}, from {} pictures{}\n", metric->name, sum / double(n - 1), n,
                        perPixel),
            remarks};
}

}  // namespace

Outcome Error(Args args) {
    return cli::RunWithOptions(args, "imgtool error", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
