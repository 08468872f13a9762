#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "../simd/permute.h"

namespace pbrt::feather {

// Structs of several V, sixteen numbers each, have Fields(), which refers to them all.

/// Element k of each field becomes the one scalar of the other tuple.
template <class... Vs, class... Ts>
void SetFields(int k, const std::tuple<Vs &...> &fields, const std::tuple<Ts &...> &ones) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        (std::get<i>(fields).Set(k, std::get<i>(ones)), ...);
    }
    (std::index_sequence_for<Vs...>());
}
/// Permute of each field.
template <class... Vs>
void PermuteFields(const std::tuple<Vs &...> &fields, const std::tuple<const Vs &...> &from,
                   const IntX16 &index) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        ((std::get<i>(fields) = Permute(std::get<i>(from), index)), ...);
    }
    (std::index_sequence_for<Vs...>());
}

}  // namespace pbrt::feather
