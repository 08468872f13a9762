// pbrt: renders scene files.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>

#include "pbrt/cli/interrupts.h"
#include "pbrt/cli/main.h"
#include "pbrt/cli/options.h"
#include "pbrt/cli/threads.h"
#include "pbrt/cli/tool.h"
#include "pbrt/reference/explain.h"
#include "pbrt/render/mse_log.h"
#include "pbrt/render/progress.h"
#include "pbrt/render/statistics.h"
#include "pbrt/rewrite/rewrite.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/say.h"
#include "pbrt/util/write_all.h"

namespace pbrt {
namespace {

constexpr int kSuccess = 0, kUserError = 1;

struct Arguments {
    std::vector<std::string> files;
    Overrides overrides;
    Options options;
    std::string statsFile, explain;
    bool stats = false, quiet = false;
    bool format = false, toPly = false, upgrade = false;
    // As written; TakeWritten puts them into `overrides`. Nothing, or 0: not given.
    std::vector<float> crop;
    std::vector<int> bounds, pixel;
    int spp = 0;
};

void DefineOptions(CLI::App *app, Arguments *a) {
    cli::AddTexts(app, "files", &a->files, "scene files, in order; none: standard input");
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
    cli::AddChoice(app, "--render-coord-sys", &a->options.renderCoordSys,
                   {"camera", "cameraworld", "world"}, "space to render in");
    cli::AddFlag(app, "--quick", &a->overrides.film.quick,
                 "a quarter of the resolution, one sample");
    cli::AddFlag(app, "--disable-pixel-jitter", &a->options.disablePixelJitter,
                 "pixel centres only");
    cli::AddFlag(app, "--disable-wavelength-jitter", &a->options.disableWavelengthJitter,
                 "the same wavelengths for every path");
    cli::AddFlag(app, "--disable-texture-filtering", &a->options.disableTextureFiltering,
                 "point-sampled textures");
    cli::AddFlag(app, "--force-diffuse", &a->options.forceDiffuse,
                 "every surface diffuse, reflecting as much as its material does");
    cli::AddText(app, "--mse-reference-image", &a->options.mseReferenceImage,
                 "picture without noise, to tell the error of this one");
    cli::AddText(app, "--mse-reference-out", &a->options.mseReferenceOut,
                 "file for lines \"spp, mean squared error\" at 1, 2, 4, ... samples per pixel");
    cli::AddFlag(app, "--stats", &a->stats, "print rays per second, memory and times");
    cli::AddText(app, "--stats-file", &a->statsFile, "write the same as JSON to this file");
    cli::AddText(app, "--explain", &a->explain,
                 "print the parameters of a plug-in, as of \"material hair\", or the names of a "
                 "family, as \"material\"; all: everything as Markdown");
    cli::AddFlag(app, "--format", &a->format, "print the scene files anew, well laid out");
    cli::AddFlag(
        app, "--toply", &a->toPly,
        "the same, with triangle meshes of 500 indices or more in PLY files beside the scene");
    cli::AddFlag(app, "--upgrade", &a->upgrade,
                 "print the scene files, of pbrt-v3, as pbrt-v4 has them");
    cli::AddFlag(app, "--quiet", &a->quiet, "no progress, no warnings");
    cli::AddFooter(app,
                   "examples:\n"
                   "  pbrt scene.pbrt --spp 64 --outfile picture.exr\n"
                   "  pbrt --quick --cropwindow 0.25,0.75,0,1 scene.pbrt\n"
                   "  pbrt --target-error 0.02 --spp 4096 --stats scene.pbrt\n");
}

int Complain(const std::string &why) {
    Say(fmt::format("Error: {}\n", why));
    return kUserError;
}

/// Prints on standard output; the exit code.
int PrintOut(std::string_view text) {
    const auto why = WriteStandardOutput(text);
    return why ? Complain(*why) : kSuccess;
}

cli::Outcome Explain(const std::string &what) {
    const reference::Explanation explanation = reference::Explain(what);
    if (explanation.error.empty()) return {kSuccess, explanation.text, {}};
    return {kUserError, {}, fmt::format("Error: {}\n", explanation.error)};
}

void TakeWritten(Arguments &a) {
    Overrides &o = a.overrides;
    if (a.spp > 0) o.spp = a.spp;
    if (!a.crop.empty()) o.film.cropWindow = {a.crop[0], a.crop[1], a.crop[2], a.crop[3]};
    if (!a.bounds.empty())
        o.film.pixelBounds = {a.bounds[0], a.bounds[1], a.bounds[2], a.bounds[3]};
    if (!a.pixel.empty())
        o.film.pixelBounds = {a.pixel[0], a.pixel[0] + 1, a.pixel[1], a.pixel[1] + 1};
}

/// The first messages by place; a broken file can make thousands. Where not all are shown and there
/// are errors, warnings are left out.
void Print(const Diagnostics &log, bool quiet) {
    constexpr size_t kMost = 50;
    const bool color = isatty(STDERR_FILENO) != 0;
    const bool errorsOnly = quiet || (log.HasErrors() && log.Messages().size() > kMost);
    size_t shown = 0, more = 0;
    for (const Message *m : log.InOrderOfPlace()) {
        const bool error = m->severity == Severity::Error;
        if (quiet && !error) continue;
        if ((errorsOnly && !error) || shown == kMost) {
            ++more;
            continue;
        }
        ++shown;
        Say(fmt::format("{}{}{}: {}\n", color ? (error ? "\033[1;31m" : "\033[1;33m") : "",
                        error ? "Error" : "Warning", color ? "\033[0m" : "", m->text));
    }
    if (more > 0) Say(fmt::format("... and {} more messages.\n", more));
    for (const std::string &line : log.MissingFiles())
        Say(line + ".\n");
}

double Seconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

struct Times {
    double parse = 0, build = 0;
};

/// Rendering time and camera go into the image's metadata, as pbrt writes them.
void AddMetadata(const RenderScene &scene, const RenderStats &stats, ImageMetadata *metadata) {
    metadata->renderTimeSeconds = float(stats.seconds);
    metadata->samplesPerPixel = int(stats.samplesPerPixel);
    metadata->cameraFromWorld = Placement(scene.camera).cameraFromWorld.Matrix();
    metadata->ndcFromWorld = NDCFromWorld(scene.camera).Matrix();
}

void PrintWarnings(const RenderScene &scene, const ClampCounts &counts) {
    const auto print = [](const std::string &text) {
        if (!text.empty()) Say(fmt::format("Warning: {}\n", text));
    };
    for (const std::string &text : scene.materials.Warnings(counts))
        print(text);
    for (const MixMaterial &m : scene.mixes)
        print(m.Warnings(counts));
}

/// Statistics to where they are wanted; the exit code.
int Report(const Statistics &s, const Arguments &a) {
    const int printed = a.stats ? PrintOut(StatisticsText(s)) : kSuccess;
    if (a.statsFile.empty()) return printed;
    if (const auto why = WriteFileAtomically(a.statsFile, StatisticsJson(s))) return Complain(*why);
    return printed;
}

int Stopped(const cli::Interrupts::Caught &by) {
    Say(fmt::format("Interrupted by {}: nothing was written.\n", by.name));
    return by.exitCode;
}

/// Reports what is wrong with the files that the error is to be told by.
std::optional<MseLog> OpenMseLog(const RenderTask &task, Diagnostics &log) {
    std::optional<MseLog> mse = MseLog::Create(task.scene->options, task.scene->film, log);
    if (mse && task.targetError > 0)
        log.Error({},
                  "--target-error gives no pixel the same number of samples: leave it out, or "
                  "\"msereferenceimage\"");
    return mse;
}

int RenderAndWrite(const RenderTask &task, const Arguments &a, const Times &times,
                   std::optional<MseLog> &mse) {
    const RenderScene &scene = *task.scene;
    for (const std::string &file : {scene.film.FileName(), a.statsFile})
        if (const auto why = file.empty() ? std::nullopt : WhyNotWritable(file))
            return Complain(*why);
    const cli::Interrupts interrupts;
    Progress progress("Rendering", a.quiet);
    Image image;
    std::function<void(int)> afterPass;
    if (mse) afterPass = [&](int samples) { mse->Add(image, samples); };
    const auto stats = Render(
        task, a.overrides.nThreads,
        [&](int64_t done, int64_t total) {
            progress.Update(done, total);
            return !interrupts.First();
        },
        &image, afterPass);
    progress.Finish(stats ? "done" : "stopped");
    if (!stats) return Stopped(*interrupts.First());
    if (!a.quiet) PrintWarnings(scene, stats->rays.clamped);
    AddMetadata(scene, *stats, &image.metadata);
    if (mse) image.metadata.mse = float(mse->Error());
    if (const auto why = WriteImageSomewhere(image, scene.film.FileName(), scene.film.Format())) {
        const int failed = Complain(*why);
        return interrupts.First() ? interrupts.First()->exitCode : failed;
    }
    if (mse && mse->Problem()) return Complain(*mse->Problem());
    return Report(CollectStatistics(scene, *stats, times.parse, times.build), a);
}

/// New text of the scene files on standard output.
cli::Outcome Rewrite(const Arguments &a) {
    Diagnostics log;
    if (a.format + a.toPly + a.upgrade > 1)
        log.Error({}, "--format, --toply and --upgrade exclude each other");
    const auto task = a.upgrade ? rewrite::Task::Upgrade
                      : a.toPly ? rewrite::Task::ToPly
                                : rewrite::Task::Format;
    const std::string text =
        log.HasErrors() ? std::string() : rewrite::RewriteFiles(a.files, task, log);
    Print(log, a.quiet);
    return {log.HasErrors() ? kUserError : kSuccess, text, {}};
}

cli::Outcome Run(Arguments &a) {
    if (!a.explain.empty()) return Explain(a.explain);
    if (a.format || a.toPly || a.upgrade) return Rewrite(a);
    TakeWritten(a);
    const cli::Threads threads = cli::LimitThreads(a.overrides.nThreads);
    a.overrides.nThreads = threads.count;

    Times times;
    Diagnostics log;
    if (threads.remark) log.Warning({}, *threads.remark);
    SceneDescription description;
    description.options = a.options;
    auto start = std::chrono::steady_clock::now();
    ParseFiles(a.files, description, log);
    times.parse = Seconds(start);
    start = std::chrono::steady_clock::now();
    const std::optional<RenderTask> task = MakeRenderTask(std::move(description), a.overrides, log);
    times.build = Seconds(start);
    std::optional<MseLog> mse;
    if (task) mse = OpenMseLog(*task, log);
    Print(log, a.quiet);
    if (!task || log.HasErrors()) {
        Say(fmt::format("{} error{}; no picture was written.\n", log.ErrorCount(),
                        log.ErrorCount() == 1 ? "" : "s"));
        return {kUserError, {}, {}};
    }
    return {RenderAndWrite(*task, a, times, mse), {}, {}};
}

}  // namespace
}  // namespace pbrt

int main(int argc, char **argv) {
    return pbrt::cli::Main("pbrt", argc, argv, [](pbrt::cli::Args words) {
        return pbrt::cli::Print(pbrt::cli::RunWithOptions(
            words, "pbrt", "pbrt-feather: a spectral path tracer for iridescent feathers",
            pbrt::DefineOptions, pbrt::Run));
    });
}
