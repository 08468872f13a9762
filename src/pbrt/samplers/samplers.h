#pragma once

#include <optional>

#include "pbrt/samplers/independent.h"
#include "pbrt/samplers/stratified.h"
#include "pbrt/samplers/zsobol.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// Limit of every sampler but `stratified`, which has 2^20.
inline constexpr int kMaxSamplesPerPixel = 1 << 24;

/// The one list of samplers.
using SamplerTypes = TypeList<ZSobolSampler, IndependentSampler, StratifiedSampler>;
using Sampler = SamplerTypes::Variant;

/// Reads the sampler's parameters; `spp`, `seed` and `fullResolution` as in SamplerContext.
/// nullopt, with the error reported, where `type` is unknown; a wrong value is reported and its
/// default taken.
std::optional<Sampler> CreateSampler(ParamDict &params, std::string_view type,
                                     std::optional<int> spp, int seed, Point2i fullResolution);

}  // namespace pbrt
