#pragma once

#include <span>

#include "pbrt/base/integrator.h"
#include "pbrt/films/film.h"

namespace pbrt {

/// Some samples of some pixels of a tile.
struct SampleBatch {
    int firstPixel, lastPixel;    ///< [first, last) in the tile's list
    int firstSample, lastSample;  ///< [first, last) of each pixel

    int SamplesPerPixel() const { return lastSample - firstSample; }
    int Size() const { return (lastPixel - firstPixel) * SamplesPerPixel(); }
};

/// Largest SampleBatch::Size(): enough that packets stay full when most paths have ended, few
/// enough that their state stays in a core's own cache.
inline constexpr int kBatchSize = 2048;

/// Traces samples for one thread; what an integrator makes for the render loop. The same tile,
/// batch and samples give the same bits, whatever the object did before.
class Tracer {
  public:
    virtual ~Tracer() = default;
    /// Batches that follow are of these pixels.
    virtual void StartTile(std::span<const Point2i> pixels) = 0;
    /// Adds the batch's samples to `sums`, one for each pixel of the tile, and its rays to
    /// `counts`. batch.Size() <= kBatchSize.
    virtual void Trace(const SampleBatch &batch, std::span<Film::Pixel> sums,
                       RayCounts &counts) = 0;
};

}  // namespace pbrt
