#pragma once

#include <array>
#include <concepts>

#include "../simd/math.h"
#include "direction.h"

namespace pbrt::feather {

/// The feather at a vertex, seen from one direction; made by Barbule::SeenFrom.
/// Sampler, pdf and f read it, so that they cannot drift apart.
template <class V>
struct View {
    Direction<V> wo;
    Direction<V> meanNormal;  ///< of the facets that wo sees, about
    V pigmentChance;          ///< probability of the TRT lobes, p_t
    MaskFor<V> grazing;       ///< see Grazing: nothing is scattered
};

/// A drawn direction. `pdf` is of all lobes, 1/sr; for a gap it is the probability of the delta
/// lobe wi = -wo, and f its weight / |wi.z|.
template <std::floating_point T, int N>
struct Sample {
    Direction<T> wi;
    std::array<T, N> f;
    T pdf;
    bool isGap;
};

}  // namespace pbrt::feather
