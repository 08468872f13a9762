#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <type_traits>

#include "pbrt/simd/simd.h"

namespace pbrt {

/// Numbers that operations may treat wrongly, and others.
template <class T>
T AnyNumber(std::mt19937 &random) {
    if constexpr (std::is_floating_point_v<T>) {
        using Limits = std::numeric_limits<T>;
        const T corners[] = {0,
                             -T(0),
                             1,
                             -1,
                             T(0.5),
                             T(-2.5),
                             3,
                             Limits::max(),
                             -Limits::max(),
                             Limits::min(),
                             Limits::denorm_min(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::quiet_NaN()};
        if (random() % 2) return corners[random() % std::size(corners)];
        return std::ldexp(T(int32_t(random())), -int(random() % 40));
    } else {
        const T corners[] = {T(0), T(1), T(-1), std::numeric_limits<T>::max(),
                             std::numeric_limits<T>::min()};
        if (random() % 4 == 0) return corners[random() % std::size(corners)];
        return T(uint64_t(random()) << 32 | random());
    }
}
template <class V>
V AnyVector(std::mt19937 &random) {
    V v;
    for (int k = 0; k < V::kSize; ++k)
        v.Set(k, AnyNumber<typename V::Scalar>(random));
    return v;
}

/// Equal bits; of NaN any.
template <class T>
bool Same(T a, T b) {
    if (a != a || b != b) return a != a && b != b;
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace pbrt
