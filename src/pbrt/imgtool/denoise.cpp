#include "pbrt/denoise/denoise.h"

#include <fmt/format.h>

#include "pbrt/cli/options.h"
#include "pbrt/imgtool/command_line.h"
#include "pbrt/imgtool/pictures.h"

namespace pbrt::imgtool {
namespace {

struct Options {
    std::string file, outfile;
};

constexpr char kDescription[] =
    "Takes the noise out of R, G and B by Open Image Denoise, which scripts/denoiser.sh installs. "
    "A "
    "picture of film \"gbuffer\" keeps its edges and textures better: its albedo and normals guide "
    "the filter. All other channels stay as they are.";

void DefineOptions(CLI::App *app, Options *o) {
    cli::AddRequired(app, "picture", &o->file, "picture to read");
    AddOutfile(app, &o->outfile);
}

Outcome WithOptions(Options &o) {
    std::string remarks;
    const OrError<Image> image = Read(o.file, &remarks);
    if (!image) return Failure(image.error);
    const OrError<Image> denoised = Denoised(*image.value);
    if (!denoised) return Failure(fmt::format("{}: {}", o.file, denoised.error));
    const bool half = image.value->metadata.storedAs == "half";
    return Remarking(remarks,
                     Write(*denoised.value, o.outfile, half ? ExrPixels::Half : ExrPixels::Float));
}

}  // namespace

Outcome Denoise(Args args) {
    return cli::RunWithOptions(args, "imgtool denoise", kDescription, DefineOptions, WithOptions);
}

}  // namespace pbrt::imgtool
