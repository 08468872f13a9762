#pragma once

#include <bit>
#include <cstdint>

#include "pbrt/util/math.h"

namespace pbrt {

/// Four floats, one SIMD register; arithmetic and comparison are element by element.
using Lanes = float __attribute__((vector_size(16)));
using IntLanes = int32_t __attribute__((vector_size(16)));

inline Lanes Broadcast(float x) {
    return Lanes{x, x, x, x};
}
inline Lanes Max(Lanes a, Lanes b) {
    return a > b ? a : b;
}
inline Lanes Min(Lanes a, Lanes b) {
    return a < b ? a : b;
}
inline Lanes Abs(Lanes a) {
    return a < 0 ? -a : a;
}
inline Lanes Sqrt(Lanes a) {
    return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline float SumOf(Lanes a) {
    return (a[0] + a[1]) + (a[2] + a[3]);
}

/// To the nearest integer; |a| < 2^22.
inline Lanes Round(Lanes a) {
    constexpr float kShift = 0x1.8p23f;  // adding it leaves no bits for a fraction
    return (a + kShift) - kShift;
}

/// e^x, relative error below 2e-7 for x in [-87, 88]; below that 1e-38 or less, above it 1e38.
/// By hand because the standard library has no exponential of SIMD registers: four at once cost
/// what one std::exp does.
inline Lanes Exp(Lanes x) {
    x = Min(Max(x, Broadcast(-87.3f)), Broadcast(88));
    const Lanes n = Round(x * 1.44269504f);
    // x - n ln 2 with ln 2 in two parts, so that it keeps its digits.
    const Lanes r = (x - n * 0.693145752f) - n * 1.42860677e-6f;
    // Own minimax fit of (e^r - 1 - r) / r^2 on |r| <= ln 2 / 2.
    const Lanes q = EvaluatePolynomial(r, Broadcast(0.499999935f), Broadcast(0.166665207f),
                                       Broadcast(0.0416683874f), Broadcast(0.00836870983f),
                                       Broadcast(0.00138146131f));
    const Lanes p = 1 + (r + r * r * q);
    const IntLanes exponent = __builtin_convertvector(n, IntLanes) + 127;
    return p * std::bit_cast<Lanes>(exponent << 23);
}

}  // namespace pbrt
