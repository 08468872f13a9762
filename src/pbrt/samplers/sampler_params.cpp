#include "pbrt/samplers/sampler_params.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

namespace pbrt {
namespace {

void Advise(ParamDict &params, int samples, std::string_view name, std::string_view what) {
    params.Warning("pixelsamples", fmt::format("{} spreads its samples best where their number per "
                                               "pixel is a power of {}, which {} is not",
                                               name, what, samples));
}

}  // namespace

int ReadLimitedSamples(ParamDict &params, int def, int max, std::string_view name,
                       const SamplerContext &context) {
    const int written = params.GetOneInt(PixelSamples(def, max));
    if (context.spp <= max) return context.spp.value_or(written);
    params.Error(
        fmt::format("{} takes up to {} samples per pixel, not {}", name, max, *context.spp));
    return written;
}

void AdvisePowerOfTwo(ParamDict &params, int samples, std::string_view name) {
    if (!std::has_single_bit(uint32_t(samples))) Advise(params, samples, name, "two");
}

void AdvisePowerOfFour(ParamDict &params, int samples, std::string_view name) {
    const bool isFours =
        std::has_single_bit(uint32_t(samples)) && std::countr_zero(uint32_t(samples)) % 2 == 0;
    if (!isFours) Advise(params, samples, name, "four");
}

Point2i LimitedResolution(ParamDict &params, std::string_view name, const SamplerContext &context) {
    constexpr int kMax = 1 << 16;
    const Point2i resolution = context.fullResolution;
    const int side = std::max(resolution.x, resolution.y);
    if (side <= kMax) return resolution;
    params.Error(fmt::format("{} takes pictures of up to {} pixels a side, this one has {}", name,
                             kMax, side));
    return {1, 1};
}

}  // namespace pbrt
