#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "pbrt/build/build_scene.h"
#include "pbrt/integrators/integrators.h"
#include "pbrt/render/render_state.h"

namespace pbrt {

/// All that a render reads, ready and immutable.
struct RenderTask {
    std::unique_ptr<const RenderScene> scene;
    Integrator integrator;
    /// Above 0: a tile gets more samples, after 16, 32, 64, 128, 256 ... of them, only until the
    /// relative error of its pixels (the root of RelativeSquaredError) is at most this; all samples
    /// at most.
    ///
    /// As what stops it is what it has seen, an image is not unbiased: tiles that happen to be
    /// without rare bright paths stop early. Measured, bias of the mean and true error:
    /// matte-spheres (bench/) at 0.05 less than 1e-4 and 0.040; glass-caustic at 0.2, whose
    /// caustics are found by chance, 0.8 % too dark and 0.55.
    float targetError = 0;

    /// The samples of each pixel that are rendered, where not all of them.
    std::optional<SampleRange> part;

    /// Samples of each pixel of the whole image.
    int SamplesPerPixel() const;
    SampleRange Samples() const { return part.value_or(SampleRange{0, SamplesPerPixel()}); }
};

/// Scene settings that the command line overrides, and its settings of the render.
struct Overrides : SceneOverrides {
    float targetError = 0;            ///< RenderTask's
    std::optional<SampleRange> part;  ///< RenderTask's
};

/// Makes everything that the description names; it is left empty. Mistakes go to the log; where
/// there are any, nullopt is returned.
std::optional<RenderTask> MakeRenderTask(SceneDescription &&description, const Overrides &overrides,
                                         Diagnostics &log);

/// `done` and `total` in samples; called from any thread, often. False stops the render.
using RenderProgress = std::function<bool(int64_t done, int64_t total)>;

/// Functions that a render calls on its way.
struct RenderHooks {
    RenderProgress progress;
    /// After a piece was added, if given; any thread, several at a time.
    std::function<void()> afterPiece = {};
    /// When all pixels have their samples up to one where a block ends (BlockAt), if given.
    std::function<void(int samples)> afterPass = {};
};

/// Goes on with a render, by `nThreads` threads (0: all cores), until it is whole: all pixels get
/// their first block of samples, then their next. False where hooks.progress stopped it; then
/// `state` holds all pieces that were finished. What comes out depends neither on the number of
/// threads nor on stops.
bool GoOnRendering(const RenderTask &task, int nThreads, const RenderHooks &hooks,
                   RenderState *state);

/// Renders the film's image from its first sample to its last. nullopt where `progress` stopped it.
/// When afterPass(samples per pixel) is called, *image is the image of these.
std::optional<RenderStats> Render(const RenderTask &task, int nThreads,
                                  const RenderProgress &progress, Image *image,
                                  const std::function<void(int)> &afterPass = {});

/// Traces pieces and adds them to `sums`, in any order and number of calls: pieces that make up the
/// whole image give Render's. nullopt where `progress` stopped it.
std::optional<RenderStats> AddPieces(const RenderTask &task, std::span<const Piece> pieces,
                                     int nThreads, const RenderProgress &progress, TileSums *sums);

}  // namespace pbrt
