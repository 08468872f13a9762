#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "pbrt/cli/options.h"
#include "pbrt/image/origin.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"
#include "pbrt/util/hash.h"

namespace pbrt::imgtool {
namespace {

/// Mean and variance in one pass (Welford 1962, with weights as West 1979).
class Accumulator {
  public:
    /// `bySamples`: each image weighs as many samples as it has; else all alike.
    explicit Accumulator(bool bySamples) : bySamples(bySamples) {}

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
        const double w = bySamples ? *image.metadata.samplesPerPixel : 1;
        weight += w;
        for (size_t i = 0; i < mean.size(); ++i) {
            double v = image.Data()[i];
            if (std::isnan(v)) return "has a value that is not a number";
            if (std::isinf(v)) {
                v = 0;
                ++*infinite;
            }
            const double before = v - mean[i];
            mean[i] += before * (w / weight);
            squares[i] += w * before * (v - mean[i]);
        }
        AddOrigin(image.metadata);
        return {};
    }
    int Count() const { return count; }
    Image Mean() const {
        Image image = first;
        for (size_t i = 0; i < mean.size(); ++i)
            image.Data()[i] = float(mean[i]);
        image.metadata.samplesPerPixel.reset();
        if (bySamples) image.metadata.samplesPerPixel = int(weight);
        image.metadata.renderTimeSeconds.reset();
        image.metadata.mse.reset();
        ClearOrigin(&image.metadata);
        if (origin) SetOrigin(*origin, &image.metadata);
        return image;
    }
    /// Variance of the mean, not of one image. Where a sample has the variance s, an image of w of
    /// them has s / w; so the sum of w times squared deviations has the expectation (count - 1) s,
    /// and the mean of all has s / weight.
    Image VarianceOfMean() const {
        Image image = Mean();
        for (size_t i = 0; i < mean.size(); ++i)
            image.Data()[i] = float(squares[i] / (weight * (count - 1)));
        return image;
    }

  private:
    /// The seeds of all images, and a range around theirs, where they are of one scene.
    void AddOrigin(const ImageMetadata &metadata) {
        const std::optional<Origin> its = OriginOf(metadata);
        if (count == 1) {
            origin = its;
        } else if (!its || !origin || its->scene != origin->scene) {
            origin.reset();
        } else {
            origin->seeds.insert(origin->seeds.end(), its->seeds.begin(), its->seeds.end());
            origin->first = std::min(origin->first, its->first);
            origin->last = std::max(origin->last, its->last);
            origin->whole = std::max(origin->whole, its->whole);
        }
    }

    bool bySamples;
    Image first;
    int count = 0;
    double weight = 0;
    std::vector<double> mean, squares;
    std::optional<Origin> origin;
};

struct Options {
    std::vector<std::string> names;
    std::string outfile, varianceFile;
};

constexpr char kDescription[] =
    "Averages pictures, each weighted by its number of samples. Two that hold the same samples "
    "(scene, seed and range agree), or the same values, are refused. Values that are not numbers "
    "are an error, infinite ones count as 0.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->names, "pictures, or the beginning of their names");
    AddOutfile(app, &o->outfile);
    cli::AddText(app, "--variance-outfile", &o->varianceFile,
                 "picture of the variance of each mean value, as diff --variance reads it");
}

/// Enough of a picture to tell it from others without keeping it.
struct Known {
    std::string file;
    ImageMetadata metadata;
    uint64_t values;  ///< a hash of them
};

uint64_t HashOf(const Image &image) {
    uint64_t hash = 0;
    for (const float v : image.Data())
        hash = Hash(hash, std::bit_cast<uint32_t>(v));
    return hash;
}

/// Why two pictures should not both be counted.
std::optional<std::string> WhyNotBoth(const Known &a, const Known &b) {
    if (ShareSamples(a.metadata, b.metadata))
        return fmt::format(
            "{} and {} hold the same samples: their scene and seed are the same; "
            "render one with another --seed",
            a.file, b.file);
    const bool same = a.values == b.values && a.metadata.pixelBounds == b.metadata.pixelBounds;
    if (same && !OriginOf(a.metadata))
        return fmt::format("{} and {} are the same picture", a.file, b.file);
    return {};
}

/// The pictures as they are added; refuses doubles.
struct Pictures {
    std::vector<Known> known;

    std::optional<std::string> Add(const std::string &file, const Image &image) {
        known.push_back({file, image.metadata, HashOf(image)});
        for (size_t i = 0; i + 1 < known.size(); ++i)
            if (auto why = WhyNotBoth(known[i], known.back())) return why;
        return {};
    }
};

/// True where all files say how many samples they have; a remark where only some do.
bool AllTellSamples(const std::vector<std::string> &files, std::string *remarks) {
    size_t count = 0;
    std::string ignored;
    for (const std::string &file : files) {
        const OrError<Image> image = Read(file, &ignored);
        count += image && image.value->metadata.samplesPerPixel.value_or(0) > 0;
    }
    if (count != 0 && count < files.size())
        *remarks +=
            "imgtool: not all pictures say how many samples they have: all weigh the same\n";
    return count == files.size();
}

Outcome WithOptions(Options &o) {
    const OrError<std::vector<std::string>> files = FilesOf(o.names);
    if (!files) return Failure(files.error);

    Outcome outcome;
    Accumulator sum(AllTellSamples(*files.value, &outcome.err));
    Pictures pictures;
    for (const std::string &file : *files.value) {
        const OrError<Image> image = Read(file, &outcome.err);
        if (!image) return Failure(image.error);
        int infinite = 0;
        if (auto reason = sum.Add(*image.value, &infinite))
            return Failure(fmt::format("{}: {}", file, *reason));
        if (auto reason = pictures.Add(file, *image.value)) return Failure(*reason);
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
