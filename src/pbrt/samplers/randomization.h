#pragma once

#include <array>
#include <string_view>

#include "pbrt/samplers/sobol.h"
#include "pbrt/scene/param_row.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// Randomisation of the digits of the Sobol' points, with keys that depend on seed and dimension.
enum class Randomization { None, PermuteDigits, Owen, FastOwen };

/// Names in the order of Randomization.
inline constexpr std::array<std::string_view, 4> kRandomizations{"none", "permutedigits", "owen",
                                                                 "fastowen"};
inline constexpr ChoiceParam kRandomization{"randomization", kRandomizations[3], kRandomizations,
                                            "what is done to the digits of the Sobol' points"};

/// f(scramble), where scramble(v, key) randomises a reversed number (sobol.h); both of one type.
/// The choice is made here, once for all numbers that f makes.
template <typename F>
auto WithScramble(Randomization randomization, const F &f) {
    switch (randomization) {
        case Randomization::None:
            return f([](const auto &v, const auto &) { return v; });
        case Randomization::PermuteDigits:
            return f([](const auto &v, const auto &key) { return v ^ key; });
        case Randomization::Owen:
            return f([](const auto &v, const auto &key) { return OwenReversed(v, key); });
        default:
            return f([](const auto &v, const auto &key) { return FastOwenReversed(v, key); });
    }
}

/// A float, or as many side by side as U has integers.
template <typename U>
using UnitFloat = decltype(ToUnitFloat(U{}));

/// Reversed digits as numbers in [0, 1).
template <typename U>
Vec2<UnitFloat<U>> PairOfReversed(const U &x, const U &y) {
    return {ToUnitFloat(ReverseBits32(x)), ToUnitFloat(ReverseBits32(y))};
}

}  // namespace pbrt
