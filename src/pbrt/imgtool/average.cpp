#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

/// Mean and variance in one pass (Welford 1962).
class Accumulator {
  public:
    /// The reason where the image cannot be added. Infinite values count as 0, `infinite` of
    /// them.
    std::optional<std::string> Add(const Image &image, int *infinite) {
        if (count == 0) {
            first = image;
            mean.resize(image.Data().size());
            squares.resize(image.Data().size());
        } else if (auto mismatch = Mismatch(image, first)) {
            return mismatch;
        }
        ++count;
        for (size_t i = 0; i < mean.size(); ++i) {
            double v = image.Data()[i];
            if (std::isnan(v)) return "has a value that is not a number";
            if (std::isinf(v)) {
                v = 0;
                ++*infinite;
            }
            const double before = v - mean[i];
            mean[i] += before / count;
            squares[i] += before * (v - mean[i]);
        }
        if (samples && image.metadata.samplesPerPixel)
            *samples += *image.metadata.samplesPerPixel;
        else
            samples.reset();
        return {};
    }
    int Count() const { return count; }
    Image Mean() const {
        Image image = first;
        for (size_t i = 0; i < mean.size(); ++i)
            image.Data()[i] = float(mean[i]);
        image.metadata.samplesPerPixel = samples;
        image.metadata.renderTimeSeconds.reset();
        image.metadata.mse.reset();
        return image;
    }
    /// Variance of the mean, not of one image.
    Image VarianceOfMean() const {
        Image image = Mean();
        for (size_t i = 0; i < mean.size(); ++i)
            image.Data()[i] = float(squares[i] / (double(count) * (count - 1)));
        return image;
    }

  private:
    Image first;
    int count = 0;
    std::vector<double> mean, squares;
    std::optional<int> samples = 0;  ///< empty: some image does not say
};

struct Options {
    std::vector<std::string> names;
    std::string outfile, varianceFile;
};

constexpr char kDescription[] =
    "Averages pictures. Values that are not numbers are an error, infinite ones count "
    "as 0.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->names, "pictures, or the beginning of their names");
    AddOutfile(app, &o->outfile);
    cli::AddText(app, "--variance-outfile", &o->varianceFile,
                 "picture of the variance of each mean value, as diff --variance reads it");
}

Outcome WithOptions(Options &o) {
    const OrError<std::vector<std::string>> files = FilesOf(o.names);
    if (!files) return Failure(files.error);

    Accumulator sum;
    Outcome outcome;
    for (const std::string &file : *files.value) {
        const OrError<Image> image = Read(file, &outcome.err);
        if (!image) return Failure(image.error);
        int infinite = 0;
        if (auto reason = sum.Add(*image.value, &infinite))
            return Failure(fmt::format("{}: {}", file, *reason));
        if (infinite > 0)
            outcome.err += fmt::format("{}: {} infinite values count as 0\n", file, infinite);
    }
    if (!o.varianceFile.empty() && sum.Count() < 2)
        return Failure("a variance needs two pictures at least");
    Outcome written = Write(sum.Mean(), o.outfile, ExrPixels::Float);
    if (written.exitCode == 0 && !o.varianceFile.empty())
        written = Write(sum.VarianceOfMean(), o.varianceFile, ExrPixels::Float);
    if (written.exitCode != 0) return written;
    outcome.out = fmt::format("{} pictures averaged\n", sum.Count());
    return outcome;
}

}  // namespace

Outcome Average(Args args) {
    return cli::RunWithOptions(args, "imgtool average", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
