#pragma once

#include <optional>

#include "pbrt/samplers/halton.h"
#include "pbrt/samplers/independent.h"
#include "pbrt/samplers/padded_sobol.h"
#include "pbrt/samplers/pmj02bn.h"
#include "pbrt/samplers/sampler_params.h"
#include "pbrt/samplers/sobol_sampler.h"
#include "pbrt/samplers/stratified.h"
#include "pbrt/samplers/zsobol.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of samplers. Parser, messages and tests follow from it.
using SamplerTypes = TypeList<ZSobolSampler, IndependentSampler, StratifiedSampler, HaltonSampler,
                              SobolSampler, PaddedSobolSampler, PMJ02BNSampler>;
using Sampler = SamplerTypes::Variant;

template <SamplerType S>
inline constexpr bool kIsSampler = true;
static_assert(SamplerTypes::All([]<typename S>() { return kIsSampler<S>; }));

inline int SamplesPerPixel(const Sampler &sampler) {
    return Dispatch(sampler, [](const auto &s) { return s.SamplesPerPixel(); });
}

/// Reads the sampler's parameters; `spp`, `seed` and `fullResolution` as in SamplerContext.
/// nullopt, with the error reported, where `type` is unknown; a wrong value is reported and its
/// default taken.
std::optional<Sampler> CreateSampler(ParamDict &params, std::string_view type,
                                     std::optional<int> spp, int seed, Point2i fullResolution);

}  // namespace pbrt
