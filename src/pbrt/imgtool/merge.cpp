#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/parts.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::vector<std::string> files;
    std::string outfile;
};

constexpr char kMerge[] =
    "Joins crops and ranges of samples (pbrt --cropwindow, --pixelbounds, --sample-range) of one "
    "render. The result has the bits of a render of the whole; where samples are missing at the "
    "end it is a part again.";
constexpr char kAssemble[] =
    "As merge, for the full picture: pixels that no file has are black. Crops of other programs "
    "are taken, too.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "files", &o->files, "the parts, .exr files");
    AddOutfile(app, &o->outfile);
}

Outcome Join(const Options &o, Gaps gaps) {
    Outcome outcome;
    std::vector<Part> parts;
    for (const std::string &file : o.files) {
        OrError<Part> part = ReadPart(file, gaps == Gaps::Refused, &outcome.err);
        if (!part) return Failure(part.error);
        parts.push_back(std::move(*part.value));
    }
    if (const auto why = WhyNotOne(parts)) return Failure(*why);
    const OrError<Merged> merged = Merge(parts, gaps);
    if (!merged) return Failure(merged.error);
    const bool isHalf = parts[0].image.metadata.storedAs == "half";
    const ExrPixels pixels = isHalf ? ExrPixels::Half : ExrPixels::Float;
    const bool isPart = merged.value->sums.perPixel > 0;
    if (isPart && !o.outfile.ends_with(".exr"))
        return Failure(
            fmt::format("samples are missing, so that the picture must be an .exr file "
                        "to be joined with more; found {}",
                        o.outfile));
    const auto why =
        isPart ? WriteImageWithWords(merged.value->image, o.outfile, pixels, merged.value->sums)
               : WriteImage(merged.value->image, o.outfile, pixels);
    if (why) return Failure(*why);
    const ImageMetadata &m = merged.value->image.metadata;
    outcome.out = fmt::format("{} parts joined", parts.size());
    if (isPart) {
        const Origin origin = *OriginOf(m);
        outcome.out +=
            fmt::format(": the samples {}:{} of {}", origin.first, origin.last, origin.whole);
    }
    outcome.out += "\n";
    if (merged.value->missing > 0)
        outcome.err +=
            fmt::format("imgtool: {} pixels are in no file and black\n", merged.value->missing);
    return outcome;
}

Outcome MergeWithOptions(Options &o) {
    return Join(o, Gaps::Refused);
}

Outcome AssembleWithOptions(Options &o) {
    return Join(o, Gaps::Black);
}

}  // namespace

Outcome Merge(Args args) {
    return cli::RunWithOptions(args, "imgtool merge", kMerge, DefineOptions, MergeWithOptions);
}

Outcome Assemble(Args args) {
    return cli::RunWithOptions(args, "imgtool assemble", kAssemble, DefineOptions,
                               AssembleWithOptions);
}

}  // namespace pbrt::imgtool
