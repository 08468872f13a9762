#pragma once

#include <optional>

#include "pbrt/filters/profiles.h"
#include "pbrt/filters/separable.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

using BoxFilter = SeparableFilter<BoxProfile>;
using GaussianFilter = SeparableFilter<GaussianProfile>;
using MitchellFilter = SeparableFilter<MitchellProfile>;
using SincFilter = SeparableFilter<SincProfile>;
using TriangleFilter = SeparableFilter<TriangleProfile>;

/// The one list of filters. Parser, messages and tests follow from it.
using FilterTypes = TypeList<GaussianFilter, BoxFilter, MitchellFilter, SincFilter, TriangleFilter>;
using Filter = FilterTypes::Variant;

template <FilterType F>
inline constexpr bool kIsFilter = true;
static_assert(FilterTypes::All([]<typename F>() { return kIsFilter<F>; }));

/// u in [0, 1)^2.
inline FilterSample Sample(const Filter &filter, Point2f u) {
    return Dispatch(filter, [u](const auto &f) { return f.Sample(u); });
}

/// nullopt, with the error reported, where `type` is unknown.
std::optional<Filter> CreateFilter(ParamDict &params, std::string_view type);

}  // namespace pbrt
