#include <fmt/format.h>

#include <filesystem>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::vector<std::string> files, crops;
    std::string outfile;
    int cropSize = 96;
};

constexpr char kDescription[] =
    "Puts slanted strips of several pictures of one size side by side, the first at the left, with "
    "white lines between. With --crop a square of each picture is written, too, as crop-NAME "
    "beside "
    "--outfile.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "pictures", &o->files, "two pictures or more");
    AddOutfile(app, &o->outfile);
    cli::AddRepeated(app, "--crop", &o->crops, "upper left pixel of a square; may be repeated",
                     "x,y");
    cli::AddNumber(app, "--cropsize", &o->cropSize, {.lo = 1, .hi = 1 << 16},
                   "pixels along the squares' edges (default 96)");
}

/// A strip's left edge leans by so many columns a row.
constexpr double kSlope = 0.25;

Image Strips(const std::vector<Image> &images) {
    const Image &first = images[0];
    const auto [width, height] = first.Resolution();
    Image out(first.Resolution(), first.ChannelNames());
    out.metadata = first.metadata;
    const double strip = double(width) / double(images.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            // The edges meet the strips' borders half-way down.
            const double at = (x + 0.5 + kSlope * (y - height / 2.)) / strip;
            const double whole = std::clamp(std::floor(at), 0., double(images.size() - 1));
            const bool edge = whole > 0 && (at - whole) * strip < 1;
            for (int c = 0; c < out.NChannels(); ++c)
                out.Set({x, y}, c, edge ? 1 : images[size_t(whole)].Get({x, y}, c));
        }
    return out;
}

/// The square's corner, or why `text` is none.
OrError<Point2i> Corner(const std::string &text) {
    const std::vector<std::string> words = cli::SplitList(text);
    cli::Domain domain{.lo = 0, .hi = 1 << 24};
    if (words.size() == 2) {
        const auto x = cli::ReadOne<int>(words[0], &domain),
                   y = cli::ReadOne<int>(words[1], &domain);
        if (x && y) return {Point2i{*x, *y}, {}};
    }
    return {{}, fmt::format("--crop: expected 2 whole numbers x,y of at least 0, found {}", text)};
}

/// "crop-NAME" in the folder of `outfile`; "crop-2-NAME" for the second square of several.
std::string CropName(const Options &o, size_t crop, const std::string &file) {
    const std::filesystem::path folder = std::filesystem::path(o.outfile).parent_path();
    const std::string number = o.crops.size() > 1 ? fmt::format("{}-", crop + 1) : "";
    const std::filesystem::path name(file);
    const std::string extension = CanWriteImage(file) ? name.extension().string() : ".exr";
    return (folder / fmt::format("crop-{}{}{}", number, name.stem().string(), extension)).string();
}

Outcome WriteCrops(const Options &o, const std::vector<Image> &images) {
    for (size_t k = 0; k < o.crops.size(); ++k) {
        const OrError<Point2i> corner = Corner(o.crops[k]);
        if (!corner) return Failure(corner.error);
        for (size_t i = 0; i < images.size(); ++i) {
            const auto [x, y] = *corner.value;
            const OrError<Image> part = Crop(images[i], {x, x + o.cropSize, y, y + o.cropSize});
            if (!part) return Failure(fmt::format("{}: {}", o.files[i], part.error));
            Outcome written = Write(*part.value, CropName(o, k, o.files[i]), ExrPixels::Half);
            if (written.exitCode != 0) return written;
        }
    }
    return {};
}

Outcome WithOptions(Options &o) {
    if (o.files.size() < 2) return Failure("splitn needs two pictures at least");
    std::string remarks;
    std::vector<Image> images;
    for (const std::string &file : o.files) {
        OrError<Image> image = Read(file, &remarks);
        if (!image) return Failure(image.error);
        if (!images.empty())
            if (const auto mismatch = Mismatch(images[0], *image.value))
                return Failure(fmt::format("{}: {}", file, *mismatch));
        images.push_back(std::move(*image.value));
    }
    Outcome outcome = Write(Strips(images), o.outfile, ExrPixels::Half);
    if (outcome.exitCode == 0) outcome = WriteCrops(o, images);
    return Remarking(remarks, std::move(outcome));
}

}  // namespace

Outcome SplitN(Args args) {
    return cli::RunWithOptions(args, "imgtool splitn", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
