#pragma once

#include <string_view>
#include <variant>

#include "pbrt/scene/params.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

class IndependentSampler;
class StratifiedSampler;
class ZSobolSampler;

// Each sampler is a small copyable class in its own header, with
//   static constexpr std::string_view kName
//   int SamplesPerPixel() const
//   void StartPixelSample(Point2i pixel, int sampleIndex, int dimension = 0)
//   float Get1D();      in [0, 1)
//   Point2f Get2D();    in [0, 1)^2
//   Point2f GetPixel2D();   the pixel's own pair, drawn before the others
// and the law: the same (pixel, index, dimension, seed) gives the same numbers, in any order.
// `Sampler` is the closed set of them; the render loop visits it once per tile, not per number.

}  // namespace pbrt
