// pbrt: renders scene files.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <sstream>

#include "pbrt/cli/interrupts.h"
#include "pbrt/cli/main.h"
#include "pbrt/cli/threads.h"
#include "pbrt/cpu/build.h"
#include "pbrt/cpu/progress.h"
#include "pbrt/cpu/statistics.h"
#include "pbrt/util/args.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/say.h"
#include "pbrt/util/write_all.h"

namespace pbrt {
namespace {

constexpr int kSuccess = 0, kUserError = 1;

constexpr size_t kLongestMessage = 2000;

struct Arguments {
    std::vector<std::string> files;
    Overrides overrides;
    Options options;
    std::string statsFile;
    bool stats = false, quiet = false;
};

/// Defines the options of the command line; they write into `a`.
void DefineOptions(CLI::App &app, Arguments &a, std::vector<float> &crop, std::vector<int> &bounds,
                   std::vector<int> &pixel, int &spp) {
    app.add_option("files", a.files, "scene files, in order; none: standard input");
    app.add_option("--outfile", a.overrides.film.outfile, "picture to write (.exr, .png, .pfm)");
    app.add_option("--spp", spp, "samples per pixel")->check(CLI::PositiveNumber);
    app.add_option("--target-error", a.overrides.targetError,
                   "stop sampling tiles whose estimated relative error is below this, as in 0.02; "
                   "--spp is the most")
        ->check(CLI::PositiveNumber);
    app.add_option("--nthreads", a.overrides.nThreads, "threads; default: all cores")
        ->check(CLI::PositiveNumber);
    app.add_option("--seed", a.options.seed, "of the samplers");
    app.add_option("--cropwindow", crop, "x0,x1,y0,y1 in [0, 1]")->delimiter(',')->expected(4);
    app.add_option("--pixelbounds", bounds, "x0,x1,y0,y1 in pixels")->delimiter(',')->expected(4);
    app.add_option("--pixel", pixel, "x,y: this pixel only")->delimiter(',')->expected(2);
    app.add_option("--render-coord-sys", a.options.renderCoordSys, "space to render in")
        ->check(CLI::IsMember({"camera", "cameraworld", "world"}));
    app.add_flag("--quick", a.overrides.film.quick, "a quarter of the resolution, one sample");
    app.add_flag("--disable-pixel-jitter", a.options.disablePixelJitter, "pixel centres only");
    app.add_flag("--disable-wavelength-jitter", a.options.disableWavelengthJitter,
                 "the same wavelengths for every path");
    app.add_flag("--disable-texture-filtering", a.options.disableTextureFiltering,
                 "point-sampled textures");
    app.add_flag("--stats", a.stats, "print rays per second, memory and times");
    app.add_option("--stats-file", a.statsFile, "write the same as JSON to this file");
    app.add_flag("--quiet", a.quiet, "no progress, no warnings");
    app.set_version_flag("--version", "pbrt-feather " PBRT_VERSION);
    app.footer(std::string(cli::kMemoryLimitHelp));
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

struct ParsedArguments {
    Arguments arguments;
    std::optional<int> exitCode;
};

ParsedArguments ParseArguments(cli::Args words) {
    ParsedArguments result;
    Arguments &a = result.arguments;
    CLI::App app{"pbrt-feather: a spectral path tracer for iridescent feathers"};
    std::vector<float> crop;
    std::vector<int> bounds, pixel;
    int spp = 0;
    DefineOptions(app, a, crop, bounds, pixel, spp);
    NormalizedArgs normal = NormalizeArgs(words, ArgOptionsOf(app));
    if (!normal.error.empty()) {
        Say(fmt::format("pbrt: {}\nRun pbrt --help for the list of options.\n",
                        Shortened(normal.error, kLongestMessage)));
        result.exitCode = kUserError;
        return result;
    }
    std::reverse(normal.args.begin(), normal.args.end());  // CLI11 takes them from the back
    try {
        app.parse(normal.args);
    } catch (const CLI::Success &e) {
        std::ostringstream text;
        app.exit(e, text, text);
        result.exitCode = PrintOut(text.str());
        return result;
    } catch (const CLI::ParseError &e) {
        Say(fmt::format("pbrt: {}\nRun pbrt --help for the list of options.\n",
                        Shortened(e.what(), kLongestMessage)));
        result.exitCode = kUserError;
        return result;
    }
    if (spp > 0) a.overrides.spp = spp;
    if (!crop.empty()) a.overrides.film.cropWindow = {crop[0], crop[1], crop[2], crop[3]};
    if (!bounds.empty())
        a.overrides.film.pixelBounds = {bounds[0], bounds[1], bounds[2], bounds[3]};
    if (!pixel.empty())
        a.overrides.film.pixelBounds = {pixel[0], pixel[0] + 1, pixel[1], pixel[1] + 1};
    return result;
}

void Print(const Diagnostics &log, bool quiet) {
    const bool color = isatty(STDERR_FILENO) != 0;
    for (const Message &m : log.Messages()) {
        const bool error = m.severity == Severity::Error;
        if (quiet && !error) continue;
        Say(fmt::format("{}{}{}: {}\n", color ? (error ? "\033[1;31m" : "\033[1;33m") : "",
                        error ? "Error" : "Warning", color ? "\033[0m" : "", m.text));
    }
}

double Seconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

struct Times {
    double parse = 0, build = 0;
};

/// Rendering time and camera go into the picture's metadata, as pbrt writes them.
Image Finished(const World &world, const RenderStats &stats) {
    Image image = world.film.ToImage();
    image.metadata.renderTimeSeconds = float(stats.seconds);
    // The mean where --target-error stops tiles.
    image.metadata.samplesPerPixel = int(stats.cameraSamples / world.film.Bounds().Area());
    image.metadata.cameraFromWorld = world.camera.CameraFromWorld().Matrix();
    image.metadata.ndcFromWorld = world.camera.NDCFromWorld().Matrix();
    return image;
}

void PrintRemarks(const World &world) {
    const auto print = [](const std::string &remarks) {
        if (!remarks.empty()) Say(fmt::format("Warning: {}\n", remarks));
    };
    for (const Material &m : world.materials)
        print(Remarks(m));
    for (const MixMaterial &m : world.mixes)
        print(m.Remarks());
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

int RenderAndWrite(World &world, const Arguments &a, const Times &times) {
    for (const std::string &file : {world.film.FileName(), a.statsFile})
        if (const auto why = file.empty() ? std::nullopt : WhyNotWritable(file))
            return Complain(*why);
    const cli::Interrupts interrupts;
    Progress progress("Rendering", a.quiet);
    const auto stats = Render(world, a.overrides.nThreads, [&](int64_t done, int64_t total) {
        progress.Update(done, total);
        return !interrupts.First();
    });
    progress.Finish(stats ? "done" : "stopped");
    if (!stats) return Stopped(*interrupts.First());
    if (!a.quiet) PrintRemarks(world);
    if (const auto why = WriteImageSomewhere(Finished(world, *stats), world.film.FileName(),
                                             world.film.Format())) {
        const int failed = Complain(*why);
        return interrupts.First() ? interrupts.First()->exitCode : failed;
    }
    return Report(CollectStatistics(world, *stats, times.parse, times.build), a);
}

int Main(cli::Args words) {
    ParsedArguments parsed = ParseArguments(words);
    if (parsed.exitCode) return *parsed.exitCode;
    Arguments &a = parsed.arguments;
    const cli::Threads threads = cli::LimitThreads(a.overrides.nThreads);
    a.overrides.nThreads = threads.count;

    Times times;
    Diagnostics log;
    if (threads.remark) log.Warning({}, *threads.remark);
    Description scene;
    scene.options = a.options;
    auto start = std::chrono::steady_clock::now();
    ParseFiles(a.files, scene, log);
    times.parse = Seconds(start);
    start = std::chrono::steady_clock::now();
    const std::unique_ptr<World> world = BuildWorld(scene, a.overrides, log);
    times.build = Seconds(start);
    Print(log, a.quiet);
    if (!world || log.HasErrors()) {
        Say(fmt::format("{} error{}; no picture was written.\n", log.ErrorCount(),
                        log.ErrorCount() == 1 ? "" : "s"));
        return kUserError;
    }
    return RenderAndWrite(*world, a, times);
}

}  // namespace
}  // namespace pbrt

int main(int argc, char **argv) {
    return pbrt::cli::Main("pbrt", argc, argv, pbrt::Main);
}
