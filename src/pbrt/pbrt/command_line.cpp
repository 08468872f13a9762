#include "pbrt/pbrt/command_line.h"

#include <fmt/format.h>

#include "pbrt/cli/options.h"

namespace pbrt::program {
namespace {

/// "a:b", two whole numbers.
std::optional<std::pair<int, int>> ReadPair(const std::string &text) {
    const size_t colon = text.find(':');
    if (colon == text.npos) return {};
    cli::Domain any;
    const auto first = cli::ReadOne<int>(text.substr(0, colon), &any);
    const auto last = cli::ReadOne<int>(text.substr(colon + 1), &any);
    if (!first || !last) return {};
    return std::pair(*first, *last);
}

void AddSampleRange(CLI::App *app, Arguments *a) {
    const std::string option = "--sample-range";
    cli::AddWord(
        app, option,
        [=](const std::string &text) {
            const auto range = ReadPair(text);
            if (!range || range->first < 0 || range->second <= range->first)
                cli::Refuse(option, "whole numbers a:b with 0 <= a < b", text);
            a->overrides.part = {range->first, range->second};
        },
        "of each pixel's samples, which are counted from 0, those from a to before b only; imgtool "
        "merge joins such parts",
        "a:b");
}

void AddFrames(CLI::App *app, Arguments *a) {
    const std::string option = "--frames";
    cli::AddWord(
        app, option,
        [=](const std::string &text) {
            const auto range = ReadPair(text);
            if (!range || range->second < range->first)
                cli::Refuse(option, "whole numbers first:last", text);
            a->frames = {range->first, range->second};
        },
        "render these, the last included; $frame, or $(7.5 * (frame - 1)), in scene files and in "
        "names of files to write stands for the number; frames whose picture exists are skipped",
        "first:last");
}

void AddCheckpoint(CLI::App *app, Arguments *a) {
    const std::string option = "--checkpoint";
    cli::AddWord(
        app, option,
        [=](const std::string &text) {
            CheckpointOption &c = a->checkpoint;
            const size_t comma = text.rfind(',');
            c.file = text.substr(0, comma);
            if (comma != text.npos) {
                cli::Domain seconds = cli::kFromZero;
                const auto number = cli::ReadOne<double>(text.substr(comma + 1), &seconds);
                if (!number || c.file.empty())
                    cli::Refuse(option, "a file, or a file and seconds, as in half.ck,30", text);
                c.seconds = *number;
            }
            if (c.file.empty()) cli::Refuse(option, "the name of a file", text);
        },
        "keep in this file what is done, every so many seconds (60) and when a signal stops the "
        "render; --resume goes on from it",
        "FILE[,seconds]");
}

void AddPicture(CLI::App *app, Arguments *a) {
    cli::AddText(app, "--outfile", &a->overrides.film.outfile,
                 "picture to write (.exr, .png, .pfm)");
    cli::AddNumber(app, "--spp", &a->spp, {.lo = 1, .hi = kMaxSamplesPerPixel},
                   "samples per pixel");
    cli::AddNumber(app, "--target-error", &a->overrides.targetError, cli::kAboveZero,
                   "stop sampling tiles whose estimated relative error is below this, as in 0.02; "
                   "--spp is the most");
    cli::AddNumber(app, "--nthreads", &a->overrides.nThreads, cli::kAboveZero,
                   "threads; default: all cores");
    cli::AddNumber(app, "--seed", &a->options.seed, {}, "of the samplers");
    cli::AddNumbers(app, "--cropwindow", &a->crop, "x0,x1,y0,y1", {},
                    "this part of the picture only, which is [0, 1] x [0, 1]");
    CLI::Option *const boundsOption =
        cli::AddNumbers(app, "--pixelbounds", &a->bounds, "x0,x1,y0,y1", {}, "these pixels only");
    CLI::Option *const pixelOption = cli::AddNumbers(
        app, "--pixel", &a->pixel, "x,y", {.lo = 0, .hi = kMaxResolution - 1}, "this pixel only");
    cli::Exclude(pixelOption, boundsOption);
    cli::AddFlag(app, "--quick", &a->overrides.film.quick,
                 "a quarter of the resolution, one sample");
}

void AddHowToRender(CLI::App *app, Arguments *a) {
    cli::AddChoice(app, "--render-coord-sys", &a->options.renderCoordSys,
                   {"camera", "cameraworld", "world"}, "space to render in");
    cli::AddFlag(app, "--disable-pixel-jitter", &a->options.disablePixelJitter,
                 "pixel centres only");
    cli::AddFlag(app, "--disable-wavelength-jitter", &a->options.disableWavelengthJitter,
                 "the same wavelengths for every path");
    cli::AddFlag(app, "--disable-texture-filtering", &a->options.disableTextureFiltering,
                 "point-sampled textures");
    cli::AddFlag(app, "--force-diffuse", &a->options.forceDiffuse,
                 "every surface diffuse, reflecting as much as its material does");
}

void AddDenoise(CLI::App *app, Arguments *a) {
    cli::AddFlag(app, "--denoise", &a->denoise,
                 "take the noise out of the finished picture, by Open Image Denoise, which "
                 "scripts/denoiser.sh installs");
}

void AddWatching(CLI::App *app, Arguments *a) {
    cli::AddFlag(app, "--write-partial-images", &a->writePartialImages,
                 "write the picture after 1, 4, 16, 32, 64, 128 ... samples per pixel, too");
    cli::AddText(app, "--display-server", &a->displayServer,
                 "show the picture as it forms in a viewer, such as tev, that listens there",
                 "host:port");
    cli::AddText(app, "--mse-reference-image", &a->options.mseReferenceImage,
                 "picture without noise, to tell the error of this one");
    cli::AddText(app, "--mse-reference-out", &a->options.mseReferenceOut,
                 "file for lines \"spp, mean squared error\" at 1, 4, 16, 32, 64, 128 ... samples "
                 "per pixel");
    cli::AddFlag(app, "--pixelstats", &a->options.pixelStats,
                 "write NAME-stats.exr beside the picture: samples, and mean seconds and rays of "
                 "each tile's pixels");
    cli::AddFlag(app, "--stats", &a->stats, "print rays per second, memory and times");
    cli::AddText(app, "--stats-file", &a->statsFile, "write the same as JSON to this file");
    cli::AddText(app, "--explain", &a->explain,
                 "print the parameters of a plug-in, as of \"material hair\", or the names of a "
                 "family, as \"material\"; all: everything as Markdown");
}

void AddRewriting(CLI::App *app, Arguments *a) {
    cli::AddFlag(app, "--format", &a->format, "print the scene files anew, well laid out");
    cli::AddFlag(
        app, "--toply", &a->toPly,
        "the same, with triangle meshes of 500 indices or more in PLY files beside the scene");
    cli::AddFlag(app, "--upgrade", &a->upgrade,
                 "print the scene files, of pbrt-v3, as pbrt-v4 has them");
}

}  // namespace

void DefineOptions(CLI::App *app, Arguments *a) {
    cli::AddTexts(app, "files", &a->files, "scene files, in order; none: standard input");
    AddPicture(app, a);
    AddSampleRange(app, a);
    AddFrames(app, a);
    AddCheckpoint(app, a);
    cli::AddText(app, "--resume", &a->resume,
                 "go on from this checkpoint; the rest of the command line as it was. New ones are "
                 "written there, unless --checkpoint names another file",
                 "FILE");
    AddHowToRender(app, a);
    AddDenoise(app, a);
    AddWatching(app, a);
    AddRewriting(app, a);
    cli::AddFlag(app, "--quiet", &a->quiet, "no progress, no warnings");
    cli::AddFooter(app,
                   "examples:\n"
                   "  pbrt scene.pbrt --spp 64 --outfile picture.exr\n"
                   "  pbrt --quick --cropwindow 0.25,0.75,0,1 scene.pbrt\n"
                   "  pbrt --target-error 0.02 --spp 4096 --stats scene.pbrt\n"
                   "  pbrt --checkpoint neck.ck neck.pbrt, and when it was stopped:\n"
                   "  pbrt --resume neck.ck neck.pbrt\n");
}

void TakeWritten(Arguments *a) {
    Overrides &o = a->overrides;
    o.film.denoised = a->denoise;
    if (a->spp > 0) o.spp = a->spp;
    if (!a->crop.empty()) o.film.cropWindow = {a->crop[0], a->crop[1], a->crop[2], a->crop[3]};
    if (!a->bounds.empty())
        o.film.pixelBounds = {a->bounds[0], a->bounds[1], a->bounds[2], a->bounds[3]};
    if (!a->pixel.empty())
        o.film.pixelBounds = {a->pixel[0], a->pixel[0] + 1, a->pixel[1], a->pixel[1] + 1};
    if (a->checkpoint.file.empty()) a->checkpoint.file = a->resume;
}

}  // namespace pbrt::program
