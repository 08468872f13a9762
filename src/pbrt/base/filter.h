#pragma once

#include <concepts>

#include "pbrt/base/plug_in.h"
#include "pbrt/util/vecmath.h"

// The contract of a pixel filter: how the samples around a pixel's centre are weighed. The closed
// list of filters is in pbrt/filters/filters.h.

namespace pbrt {

class ParamDict;

/// Offset from the pixel's centre, in pixels, and f / pdf, which may be negative.
struct FilterSample {
    Vector2f p;
    float weight;
};

/// Copyable and immutable once made; any thread may read it. Filters may be negative, but their
/// integral is positive.
///
///   Create(params)  reads all parameters; mistakes are reported through params, and the filter is
///                   usable all the same
///   Radius()        half width and height, pixels, > 0: the filter is 0 beyond
///   Evaluate(p)     its value at an offset from the pixel's centre, pixels; of any scale
///   Integral()      of Evaluate over the plane, > 0
///   Sample(u)       an offset within the radius, drawn by u in [0, 1)^2 with a density that is
///                   about proportional to |Evaluate|. The mean of g(p) weight over u is the
///                   integral of g times Evaluate, for any g
template <typename F>
concept FilterType = PlugInType<F> && std::copy_constructible<F> &&
    requires(const F f, ParamDict &params, Point2f p) {
    { F::Create(params) } -> std::same_as<F>;
    { f.Radius() } -> std::same_as<Vector2f>;
    { f.Evaluate(p) } -> std::same_as<float>;
    { f.Integral() } -> std::same_as<float>;
    { f.Sample(p) } -> std::same_as<FilterSample>;
};

}  // namespace pbrt
