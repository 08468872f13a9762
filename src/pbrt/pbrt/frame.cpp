#include "pbrt/pbrt/frame.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "pbrt/cli/interrupts.h"
#include "pbrt/denoise/denoise.h"
#include "pbrt/pbrt/checkpointer.h"
#include "pbrt/pbrt/display_server.h"
#include "pbrt/pbrt/messages.h"
#include "pbrt/pbrt/output.h"
#include "pbrt/pbrt/progress.h"
#include "pbrt/render/mse_log.h"
#include "pbrt/render/part.h"
#include "pbrt/render/statistics.h"
#include "pbrt/util/atomic_file.h"
#include "pbrt/util/say.h"

namespace pbrt::program {
namespace {

double Seconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

struct Times {
    double parse = 0, build = 0;
};

/// A scene that is ready, and what its picture will be.
struct Ready {
    RenderTask task;
    RenderIdentity identity;
    Times times;
    std::optional<MseLog> mse;
};

void PrintWarnings(const RenderScene &scene, const ClampCounts &counts) {
    const auto print = [](const std::string &text) {
        if (!text.empty()) Warn(text);
    };
    for (const std::string &text : scene.materials.Warnings(counts))
        print(text);
    for (const MixMaterial &m : scene.mixes)
        print(m.Warnings(counts));
}

/// Reports what of the command line does not fit the scene.
void CheckFit(const Arguments &a, const RenderTask &task, const MseLog *mse, Diagnostics &log) {
    if (mse && task.targetError > 0)
        log.Error({},
                  "--target-error gives no pixel the same number of samples: leave it out, or "
                  "\"msereferenceimage\"");
    if (mse && !a.resume.empty())
        log.Error(
            {},
            "\"msereferenceout\" has a line for each pass from the first, which --resume does "
            "not repeat: leave one out");
    if (!task.part) return;
    if (const auto why = WhyNoPart(*task.part, task.SamplesPerPixel()))
        log.Error({},
                  fmt::format("--sample-range {}:{}: {}", task.part->first, task.part->last, *why));
    const std::string &file = task.scene->film.FileName();
    if (!file.ends_with(".exr"))
        log.Error({},
                  fmt::format("--sample-range: the picture must be an .exr file, which can hold "
                              "what imgtool merge needs; found \"{}\"",
                              file));
}

/// The name of the picture of a scene that is parsed; mistakes in its film are told later.
std::string PictureOf(const SceneDescription &description, const FilmOverrides &overrides) {
    Diagnostics ignored;
    return Film::Create(description, overrides, ignored).FileName();
}

/// A render from the first sample, or from a checkpoint, to a file.
class Rendering {
  public:
    Rendering(Ready &ready, const Arguments &arguments, Progress *progress)
        : ready(ready),
          a(arguments),
          progress(progress),
          film(ready.task.scene->film),
          state(ready.task),
          checkpoints(a.checkpoint, ready.identity, state) {}

    int Run() {
        if (const auto why = WhyNotReady()) return Complain(*why);
        if (!a.resume.empty())
            if (const auto why = ReadCheckpoint(a.resume, ready.identity, &state))
                return Complain(fmt::format("--resume: {}", *why));
        Connect();
        const bool done = Render();
        display.reset();
        progress->Finish(done ? "done" : "stopped");
        return done ? Write() : Stop();
    }

  private:
    std::optional<std::string> WhyNotReady() const {
        std::vector<std::string> files{film.FileName(), a.statsFile, a.checkpoint.file};
        if (ready.task.scene->options.pixelStats) files.push_back(CostName(film.FileName()));
        for (const std::string &file : files)
            if (const auto why = file.empty() ? std::nullopt : WhyNotWritable(file)) return why;
        return {};
    }

    void Connect() {
        if (a.displayServer.empty()) return;
        auto server = DisplayServer::Connect(a.displayServer, film.FileName(), film, state);
        if (server)
            display = std::move(*server.value);
        else
            Warn(server.error);
    }

    bool Render() {
        const int spp = state.Samples().Size();
        progress->Begin("Rendering", [this, spp] {
            const RenderState::Progress now = state.HowFar();
            return Progress::Status{now.done, now.total, spp, now.rays};
        });
        RenderHooks hooks{[this](int64_t, int64_t) { return !interrupts.First(); },
                          [this] { checkpoints.AfterPiece(); }};
        if (ready.mse || a.writePartialImages)
            hooks.afterPass = [this](int samples) { AfterPass(samples - state.Samples().first); };
        return GoOnRendering(ready.task, a.overrides.nThreads, hooks, &state);
    }

    void AfterPass(int samples) {
        Image image = state.Develop();
        if (ready.mse) ready.mse->Add(image, samples);
        if (!a.writePartialImages || samples == state.Samples().Size()) return;
        AddMetadata(ready.task, ready.identity, samples, &image.metadata);
        Origin origin = OriginOf(ready.identity);
        origin.last = origin.first + samples;
        SetOrigin(origin, &image.metadata);
        const auto why = WriteImage(image, film.FileName(), film.Format());
        if (why && !complained) Warn(*why);
        complained = complained || why;
    }

    int Stop() {
        const cli::Interrupts::Caught by = *interrupts.First();
        const RenderState::Progress now = state.HowFar();
        const double percent = 100 * double(now.done) / double(now.total);
        std::string what = "nothing was written";
        if (checkpoints.Writes()) {
            if (const auto why = checkpoints.Write())
                Complain(fmt::format("no checkpoint: {}", *why));
            else
                what = fmt::format(
                    "wrote the checkpoint {}, with {:.0f} % of the samples; "
                    "--resume {} goes on",
                    checkpoints.File(), percent, checkpoints.File());
        }
        if (what == "nothing was written" && now.done > 0) {
            const SampleRange spread = state.Spread();
            if (const auto why = WritePartial(ready.task, ready.identity, state))
                Complain(*why);
            else
                what = fmt::format(
                    "wrote {} with what is finished, {} to {} of {} samples of each "
                    "pixel; its channel \"samples\" says how many",
                    PartialName(film.FileName()), spread.first, spread.last,
                    state.Samples().Size());
        }
        Say(fmt::format("Interrupted by {}: {}.\n", by.name, what));
        return by.exitCode;
    }

    int Write() {
        const RenderStats stats = state.Stats();
        if (!a.quiet) PrintWarnings(*ready.task.scene, stats.rays.clamped);
        Image image = state.Develop();
        if (a.denoise) Denoise(&image);
        AddMetadata(ready.task, ready.identity, int(stats.samplesPerPixel), &image.metadata);
        if (ready.mse) image.metadata.mse = float(ready.mse->Error());
        if (const auto why = WritePicture(ready.task, ready.identity, state, image))
            return KeepWhatIsDone(*why);
        if (checkpoints.Writes()) std::filesystem::remove(checkpoints.File(), ignored);
        if (const auto why = WriteCosts()) return Complain(*why);
        if (ready.mse && ready.mse->Problem()) return Complain(*ready.mse->Problem());
        const Times &t = ready.times;
        const int reported = Report(CollectStatistics(*ready.task.scene, stats, t.parse, t.build));
        if (!a.quiet)
            Say(WroteText(film.FileName(), stats.samplesPerPixel,
                          t.parse + t.build + stats.seconds) +
                "\n");
        return reported;
    }

    void Denoise(Image *image) {
        progress->Begin("Denoising");
        OrError<Image> denoised = Denoised(*image);
        progress->Clear();
        if (denoised)
            *image = std::move(*denoised.value);
        else
            Warn(fmt::format("the picture is written with its noise: {}", denoised.error));
        if (film.ForDenoiserOnly()) *image = *SelectChannels(*image, {"R", "G", "B"}).value;
    }

    /// After a picture could not be written.
    int KeepWhatIsDone(const std::string &why) {
        int exitCode = Complain(why);
        if (checkpoints.Writes() && !checkpoints.Write())
            Say(
                fmt::format("All samples are in the checkpoint {}: --resume {} writes the picture "
                            "when there is room.\n",
                            checkpoints.File(), checkpoints.File()));
        return interrupts.First() ? interrupts.First()->exitCode : exitCode;
    }

    std::optional<std::string> WriteCosts() const {
        if (!ready.task.scene->options.pixelStats) return {};
        return WriteImage(CostImage(film, state), CostName(film.FileName()), ExrPixels::Float);
    }

    /// Statistics to where they are wanted; the exit code.
    int Report(const Statistics &s) const {
        const int printed = a.stats ? PrintOut(StatisticsText(s)) : kSuccess;
        if (a.statsFile.empty()) return printed;
        if (const auto why = WriteFileAtomically(a.statsFile, StatisticsJson(s)))
            return Complain(*why);
        return printed;
    }

    Ready &ready;
    const Arguments &a;
    Progress *progress;
    const Film &film;
    RenderState state;
    Checkpointer checkpoints;
    const cli::Interrupts interrupts;
    std::unique_ptr<DisplayServer> display;
    bool complained = false;  ///< of partial images
    std::error_code ignored;
};

/// nullopt after mistakes, which are in the log.
std::optional<Ready> Build(SceneDescription &&description, const Arguments &a, Diagnostics &log) {
    RenderIdentity identity = IdentityOf(description, a.overrides);
    std::optional<RenderTask> task = MakeRenderTask(std::move(description), a.overrides, log);
    if (!task) return {};
    std::optional<MseLog> mse = MseLog::Create(task->scene->options, task->scene->film, log);
    CheckFit(a, *task, mse ? &*mse : nullptr, log);
    if (log.HasErrors()) return {};
    Complete(*task, &identity);
    return Ready{std::move(*task), std::move(identity), {}, std::move(mse)};
}

int TellErrors(const Diagnostics &log) {
    Say(fmt::format("{} error{}; no picture was written.\n", log.ErrorCount(),
                    log.ErrorCount() == 1 ? "" : "s"));
    return kUserError;
}

}  // namespace

FrameResult RenderFrame(const Arguments &a, const std::optional<std::string> &threadRemark,
                        std::optional<int> frame, const std::string &previous) {
    Progress progress(a.quiet);
    Times times;
    Diagnostics log;
    if (threadRemark) log.Warning({}, *threadRemark);
    SceneDescription description;
    description.options = a.options;
    auto start = std::chrono::steady_clock::now();
    const std::string frameText = frame ? fmt::format(", frame {}", *frame) : std::string();
    progress.Begin("Parsing" + frameText);
    ParseFiles(a.files, description, log);
    times.parse = Seconds(start);
    FrameResult result;
    if (frame && !log.HasErrors()) {
        result.picture = PictureOf(description, a.overrides.film);
        std::error_code none;
        if (result.picture == previous)
            log.Error({}, fmt::format("--frames: every frame would be written to {}; put $frame "
                                      "into its name",
                                      previous));
        else if (std::filesystem::exists(result.picture, none))
            result.skipped = true;
    }
    if (result.skipped) return result;
    start = std::chrono::steady_clock::now();
    progress.Begin("Building" + frameText);
    std::optional<Ready> ready = Build(std::move(description), a, log);
    times.build = Seconds(start);
    progress.Clear();
    Print(log, a.quiet);
    if (!ready || log.HasErrors()) {
        result.exitCode = TellErrors(log);
        return result;
    }
    ready->times = times;
    result.exitCode = Rendering(*ready, a, &progress).Run();
    return result;
}

}  // namespace pbrt::program
