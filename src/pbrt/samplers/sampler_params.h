#pragma once

#include "pbrt/base/sampler.h"
#include "pbrt/scene/params.h"

namespace pbrt {

/// Limit of every sampler that has none of its own.
inline constexpr int kMaxSamplesPerPixel = 1 << 24;

constexpr IntParam PixelSamples(int def, int max = kMaxSamplesPerPixel) {
    return {"pixelsamples", def, 1, max, "samples per pixel, unless --spp is given"};
}
inline constexpr IntParam kSeed{"seed", 0, kLeastInt, kMostInt,
                                "of the random numbers; not given: that of Option or --seed"};

/// `pixelsamples`, or the command line's.
inline int ReadSamples(ParamDict &params, int def, const SamplerContext &context) {
    const int written = params.GetOneInt(PixelSamples(def));
    return context.spp.value_or(written);
}

/// The same for the sampler `name` with a limit of its own; more on the command line is an error,
/// and the file's number is taken.
int ReadLimitedSamples(ParamDict &params, int def, int max, std::string_view name,
                       const SamplerContext &context);
/// Warns where the number of samples is no power of two, or of four, which the sampler `name` is
/// best with.
void AdvisePowerOfTwo(ParamDict &params, int samples, std::string_view name);
void AdvisePowerOfFour(ParamDict &params, int samples, std::string_view name);

/// The image's resolution for the sampler `name`, which takes up to 2^16 pixels a side; beyond them
/// one pixel, and an error.
Point2i LimitedResolution(ParamDict &params, std::string_view name, const SamplerContext &context);

/// `seed`, or the command line's.
inline int ReadSeed(ParamDict &params, const SamplerContext &context) {
    IntParam row = kSeed;
    row.def = context.seed;
    return params.GetOneInt(row);
}

}  // namespace pbrt
