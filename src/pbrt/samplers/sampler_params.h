#pragma once

#include "pbrt/base/sampler.h"
#include "pbrt/scene/params.h"

namespace pbrt {

/// Limit of every sampler but `stratified`, which has 2^20.
inline constexpr int kMaxSamplesPerPixel = 1 << 24;

constexpr IntParam PixelSamples(int def) {
    return {"pixelsamples", def, 1, kMaxSamplesPerPixel,
            "samples per pixel, unless --spp is given"};
}
inline constexpr IntParam kSeed{"seed", 0, kLeastInt, kMostInt,
                                "of the random numbers; not given: that of Option or --seed"};

/// `pixelsamples`, or the command line's.
inline int ReadSamples(ParamDict &params, int def, const SamplerContext &context) {
    const int written = params.GetOneInt(PixelSamples(def));
    return context.spp.value_or(written);
}

/// `seed`, or the command line's.
inline int ReadSeed(ParamDict &params, const SamplerContext &context) {
    IntParam row = kSeed;
    row.def = context.seed;
    return params.GetOneInt(row);
}

}  // namespace pbrt
