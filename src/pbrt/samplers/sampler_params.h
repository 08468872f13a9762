#pragma once

#include "pbrt/base/sampler.h"
#include "pbrt/scene/params.h"

namespace pbrt {

/// Limit of every sampler but `stratified`, which has 2^20.
inline constexpr int kMaxSamplesPerPixel = 1 << 24;

/// `pixelsamples`, or the command line's.
inline int ReadSamples(ParamDict &params, int def, const SamplerContext &context) {
    const int written = params.GetOneInt("pixelsamples", def, 1, kMaxSamplesPerPixel);
    return context.spp.value_or(written);
}

/// `seed`, or the command line's.
inline int ReadSeed(ParamDict &params, const SamplerContext &context) {
    return params.GetOneInt("seed", context.seed);
}

}  // namespace pbrt
