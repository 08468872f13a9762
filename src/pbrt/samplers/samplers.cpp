#include "pbrt/samplers/samplers.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr int kMaxStrata = 1 << 10;

constexpr IntParam kXSamples{"xsamples", 4, 1, kMaxStrata, "cells of a pixel across"};
constexpr IntParam kYSamples{"ysamples", 4, 1, kMaxStrata, "cells of a pixel down"};
constexpr BoolParam kJitter{"jitter", true,
                            "samples lie anywhere in their cells, not in the middle"};

/// The two factors of n that are nearest to each other, the larger first.
Point2i NearlySquare(int n) {
    int small = int(std::sqrt(float(n)));
    while (n % small != 0)
        --small;
    return {n / small, small};
}

}  // namespace

IndependentSampler IndependentSampler::Create(ParamDict &params, const SamplerContext &context) {
    return IndependentSampler(ReadSamples(params, 4, context), ReadSeed(params, context));
}

StratifiedSampler StratifiedSampler::Create(ParamDict &params, const SamplerContext &context) {
    Point2i cells{params.GetOneInt(kXSamples), params.GetOneInt(kYSamples)};
    const bool jitter = params.GetOneBool(kJitter);
    if (context.spp > kMaxStrata * kMaxStrata)
        params.Error(fmt::format("stratified takes up to {} samples per pixel, not {}",
                                 kMaxStrata * kMaxStrata, *context.spp));
    else if (context.spp)
        cells = NearlySquare(*context.spp);
    return StratifiedSampler(cells.x, cells.y, jitter, ReadSeed(params, context));
}

ZSobolSampler ZSobolSampler::Create(ParamDict &params, const SamplerContext &context) {
    const int asked = ReadSamples(params, 16, context);
    const int used = int(std::bit_floor(uint32_t(asked)));
    if (used != asked) {
        params.Warning("pixelsamples",
                       fmt::format("zsobol needs a power of two: taking {} samples per pixel "
                                   "instead of {}",
                                   used, asked));
    }
    const int randomization = params.GetOneChoice(kRandomization);
    return ZSobolSampler(used, LimitedResolution(params, kName, context),
                         Randomization(randomization), ReadSeed(params, context));
}

std::optional<Sampler> CreateSampler(ParamDict &params, std::string_view type,
                                     std::optional<int> spp, int seed, Point2i fullResolution) {
    std::optional<Sampler> sampler;
    const bool known = SamplerTypes::Visit(type, [&]<typename S>() {
        sampler = S::Create(params, {spp, seed, fullResolution});
    });
    if (!known) {
        params.Error(UnknownName("sampler", type, SamplerTypes::kNames));
        return {};
    }
    params.ReportUnused();
    return sampler;
}

}  // namespace pbrt
