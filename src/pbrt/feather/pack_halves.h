#pragma once

#include <concepts>

#include "pack.h"

namespace pbrt::feather {

// Packs whose halves belong to two directions.

/// The elements of `a`, as often as m elements need.
template <int m, std::floating_point T, int n, int bytes>
[[gnu::always_inline]] inline Pack<T, m, bytes> Repeated(const Pack<T, n, bytes> &a) {
    if constexpr (m == n)
        return a;
    else
        return Repeated<m>(Doubled(a));
}

/// The halves of a pack in each other's place; either half in both places.
template <class Pack>
[[gnu::always_inline]] inline Pack SwapHalves(const Pack &a) {
    return Permuted(a, [](int k) { return (k + Pack::kSize / 2) % Pack::kSize; });
}
template <class Pack>
[[gnu::always_inline]] inline Pack DuplicateLow(const Pack &a) {
    return Permuted(a, [](int k) { return k % (Pack::kSize / 2); });
}
template <class Pack>
[[gnu::always_inline]] inline Pack DuplicateHigh(const Pack &a) {
    return Permuted(a, [](int k) { return Pack::kSize / 2 + k % (Pack::kSize / 2); });
}
/// a in the first half, b in the second.
template <class Pack>
[[gnu::always_inline]] inline Pack Halves(ScalarOf<Pack> a, ScalarOf<Pack> b) {
    return Select(Pack::FirstHalf(), Pack(a), Pack(b));
}

/// The sum of the elements, in a fixed order.
template <std::floating_point T, int n, int bytes>
[[gnu::always_inline]] inline T Sum(const Pack<T, n, bytes> &a) {
    if constexpr (n == 2)
        return a[0] + a[1];
    else if constexpr (n * sizeof(T) == 16)
        return (a[0] + a[2]) + (a[1] + a[3]);
    else
        return Sum(Folded(a));
}

}  // namespace pbrt::feather
