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

/// Natural logarithm of normal positive numbers; error below 1.5e-7 plus 1.2e-7 of the result. By
/// hand for the same reason as Exp.
inline Lanes Log(Lanes x) {
    // x = m 2^e with m in [sqrt(1/2), sqrt(2)).
    const IntLanes bits = std::bit_cast<IntLanes>(x) - 0x3f3504f3;
    const IntLanes e = bits >> 23;
    const Lanes m = std::bit_cast<Lanes>((bits & 0x007fffff) + 0x3f3504f3);
    // log m = 2 atanh s, its series: the first term left out is below 1e-9.
    const Lanes s = (m - 1) / (m + 1), q = s * s;
    const Lanes series = EvaluatePolynomial(q, Broadcast(1), Broadcast(1.f / 3), Broadcast(1.f / 5),
                                            Broadcast(1.f / 7), Broadcast(1.f / 9));
    return 2 * s * series + __builtin_convertvector(e, Lanes) * 0.693147181f;
}

}  // namespace pbrt
