#include "pbrt/pbrt/run.h"

#include <fmt/format.h>

#include "pbrt/cli/threads.h"
#include "pbrt/denoise/denoise.h"
#include "pbrt/pbrt/frame.h"
#include "pbrt/pbrt/messages.h"
#include "pbrt/reference/explain.h"
#include "pbrt/rewrite/rewrite.h"
#include "pbrt/scene/frame_text.h"
#include "pbrt/util/say.h"

namespace pbrt::program {
namespace {

cli::Outcome Explain(const std::string &what) {
    const reference::Explanation explanation = reference::Explain(what);
    if (explanation.error.empty()) return {kSuccess, explanation.text, {}};
    return {kUserError, {}, fmt::format("Error: {}\n", explanation.error)};
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

/// Combinations that have no meaning; nullopt where there are none.
std::optional<std::string> Contradiction(const Arguments &a) {
    if (a.overrides.part && a.overrides.targetError > 0)
        return "--target-error gives no pixel the same number of samples, so that parts by "
               "--sample-range would not fit together: leave one out";
    if (a.overrides.part && a.denoise)
        return "--denoise works on whole pictures: join the parts by imgtool merge, then use "
               "imgtool denoise";
    if (a.denoise)
        if (const auto why = WhyNoDenoiser()) return fmt::format("--denoise: {}", *why);
    if (a.frames && a.files.empty())
        return "--frames reads the scene once for each frame: name its file";
    return {};
}

/// The options of one frame: names with $frame have its number.
OrError<Arguments> ForFrame(const Arguments &all, int frame, bool isFirst) {
    Arguments a = all;
    a.options.frame = frame;
    // A checkpoint is of one frame: the first that is not there yet.
    if (!isFirst && !NamesFrame(a.resume)) a.resume.clear();
    for (std::string *const name :
         {&a.overrides.film.outfile, &a.checkpoint.file, &a.resume, &a.statsFile,
          &a.options.mseReferenceOut, &a.options.mseReferenceImage}) {
        const OrError<std::string> named = PutFrameInName(*name, frame);
        if (!named) return {{}, fmt::format("{}: {}", *name, named.error)};
        *name = *named.value;
    }
    return {std::move(a), {}};
}

int RenderFrames(const Arguments &all, const std::optional<std::string> &remark) {
    std::string previous;
    bool first = true;
    for (int64_t frame = all.frames->first; frame <= all.frames->last; ++frame) {
        const OrError<Arguments> a = ForFrame(all, int(frame), first);
        if (!a) return Complain(a.error);
        const FrameResult result = RenderFrame(*a.value, remark, int(frame), previous);
        if (result.exitCode != kSuccess) return result.exitCode;
        if (result.skipped && !all.quiet)
            Say(fmt::format("frame {}: {} is there\n", frame, result.picture));
        first = first && result.skipped;
        previous = result.picture;
    }
    return kSuccess;
}

}  // namespace

cli::Outcome Run(Arguments &a) {
    if (!a.explain.empty()) return Explain(a.explain);
    if (a.format || a.toPly || a.upgrade) return Rewrite(a);
    TakeWritten(&a);
    if (const auto why = Contradiction(a)) return {Complain(*why), {}, {}};
    const cli::Threads threads = cli::LimitThreads(a.overrides.nThreads);
    a.overrides.nThreads = threads.count;
    if (a.frames) return {RenderFrames(a, threads.remark), {}, {}};
    return {RenderFrame(a, threads.remark).exitCode, {}, {}};
}

}  // namespace pbrt::program
