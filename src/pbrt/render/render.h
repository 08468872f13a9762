#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "pbrt/build/build_scene.h"
#include "pbrt/integrators/integrators.h"
#include "pbrt/render/pieces.h"

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

    int SamplesPerPixel() const;
};

/// Scene settings that the command line overrides, and its settings of the render.
struct Overrides : SceneOverrides {
    float targetError = 0;  ///< RenderTask's
};

/// Makes everything that the description names; it is left empty. Mistakes go to the log; where
/// there are any, nullopt is returned.
std::optional<RenderTask> MakeRenderTask(SceneDescription &&description, const Overrides &overrides,
                                         Diagnostics &log);

struct RenderStats {
    double seconds = 0;
    int64_t cameraSamples = 0;   ///< traced, pixels around a crop window included
    double samplesPerPixel = 0;  ///< mean over the image
    RayCounts rays;
};

/// `done` and `total` in samples; called from any thread, often. False stops the render.
using RenderProgress = std::function<bool(int64_t done, int64_t total)>;

/// Renders the film's image with `nThreads` threads (0: all cores), tile by tile. The image does
/// not depend on their number. nullopt where `progress` stopped it.
///
/// `afterPass`, if given: all pixels get their first block of samples, then their next (BlockAt),
/// and afterPass(samples per pixel) is called each time, when *image is the image of these. The
/// last is the same as without it. RenderTask::targetError is ignored; takes sizeof(Film::Pixel)
/// bytes a pixel more.
std::optional<RenderStats> Render(const RenderTask &task, int nThreads,
                                  const RenderProgress &progress, Image *image,
                                  const std::function<void(int)> &afterPass = {});

/// Sums of an unfinished image, tile by tile.
class TileSums {
  public:
    explicit TileSums(const Film &film);
    std::span<Film::Pixel> operator[](size_t tile) { return sums[tile]; }
    /// The image of the samples so far.
    void Develop(const Film &film, Image *image) const;

  private:
    std::vector<std::vector<Film::Pixel>> sums;  ///< in the order of PixelsAlongCurve
};

/// Traces pieces and adds them to `sums`, in any order and number of calls: pieces that make up the
/// whole image give Render's. nullopt where `progress` stopped it.
std::optional<RenderStats> AddPieces(const RenderTask &task, std::span<const Piece> pieces,
                                     int nThreads, const RenderProgress &progress, TileSums *sums);

}  // namespace pbrt
