#pragma once

#include <optional>
#include <string_view>

#include "pbrt/scene/params.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// What a sampler is told besides its own parameters.
struct SamplerContext {
    std::optional<int> spp;  ///< from the command line, > 0; comes before the file's
    int seed = 0;            ///< where the file gives none
    Point2i fullResolution;  ///< of the whole picture, pixels
};

// Each sampler is a small copyable class in its own header, with
//   static constexpr std::string_view kName
//   static S Create(ParamDict &, const SamplerContext &)
//   int SamplesPerPixel() const
//   void StartPixelSample(Point2i pixel, int sampleIndex, int dimension = 0)
//   float Get1D();      in [0, 1)
//   Point2f Get2D();    in [0, 1)^2
//   Point2f GetPixel2D();   the pixel's own pair, drawn before the others
// and the law: the same (pixel, index, dimension, seed) gives the same numbers, in any order.
// `dimension` counts draws of either kind.
// `Sampler` is the closed set of them; the render loop visits it once per tile, not per number.

}  // namespace pbrt
