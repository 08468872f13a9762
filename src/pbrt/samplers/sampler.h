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
// For many samples side by side, pixels of a batch by their place in the span:
//   void StartBatch(std::span<const Point2i> pixels)
//   FloatX16 Get1D(int dimension, UintX16 pixel, UintX16 index)
//   Point2fX16 Get2D(int dimension, UintX16 pixel, UintX16 index)
// with the law: lane by lane what StartPixelSample(pixels[pixel], index, dimension) and Get1D or
// Get2D give. In lanes whose numbers nobody wants pixel must still lie in the span; index may be
// anything. Batches hold until the next StartBatch; the span is read by StartBatch alone. What
// depends on the pixels is made where first asked for and kept in the sampler (about 200 bytes a
// pixel), so each thread has a sampler of its own, copied from the RenderScene's.
// `Sampler` is the closed set of them; the render loop visits it once per tile, not per number.

}  // namespace pbrt
