#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "convert.h"
#include "simd.h"

namespace pbrt {

// The functions of Simd for one number: the same results, also for zeros with a sign and for NaN.

template <class T>
requires std::is_arithmetic_v<T>
constexpr T Select(bool condition, T a, T b) {
    return condition ? a : b;
}
template <class T>
requires std::is_arithmetic_v<T>
constexpr T Min(T a, T b) {
    return a < b ? a : b;
}
template <class T>
requires std::is_arithmetic_v<T>
constexpr T Max(T a, T b) {
    return a > b ? a : b;
}
template <std::floating_point T>
inline T Abs(T a) {
    return std::abs(a);
}
template <std::floating_point T>
inline T CopySign(T a, T b) {
    return std::copysign(a, b);
}
template <std::floating_point T>
inline T MulSign(T a, T b) {
    return a * std::copysign(T(1), b);
}
template <std::floating_point T>
inline T Sqrt(T a) {
    return std::sqrt(a);
}
template <std::floating_point T>
inline T Round(T a) {
    return std::rint(a);
}
template <std::floating_point T>
inline T Floor(T a) {
    return std::floor(a);
}

/// 1 or -1, as the sign bit says.
template <class V>
[[gnu::always_inline]] inline V SignOf(const V &a) {
    return CopySign(V(1), a);
}
/// low <= high; low where a is NaN.
template <class V>
[[gnu::always_inline]] inline V Clamp(const V &a, ScalarOf<V> low, ScalarOf<V> high) {
    return Min(Max(a, V(low)), V(high));
}
/// sqrt(a), 0 where a < 0.
template <class V>
[[gnu::always_inline]] inline V SafeSqrt(const V &a) {
    return Sqrt(Max(a, V(0)));
}

/// 1 / a and 1 / sqrt(a) where the fourth digit does not count: sixteen floats are within 2^-14 of
/// the value where the processor has 64-byte registers, in a tenth to a fifth of the time; all else
/// is as exact as division. a normal, > 0.
template <class V>
[[gnu::always_inline]] inline V RcpApprox(const V &a) {
    return 1 / a;
}
template <class V>
[[gnu::always_inline]] inline V RsqrtApprox(const V &a) {
    return 1 / Sqrt(a);
}
#if defined(__AVX512F__)
[[gnu::always_inline]] inline FloatX16 RcpApprox(const FloatX16 &a) {
    FloatX16 r;
    r.part[0] = FloatX16::Register(_mm512_maskz_rcp14_ps(0xffff, __m512(a.part[0])));
    return r;
}
[[gnu::always_inline]] inline FloatX16 RsqrtApprox(const FloatX16 &a) {
    FloatX16 r;
    r.part[0] = FloatX16::Register(_mm512_maskz_rsqrt14_ps(0xffff, __m512(a.part[0])));
    return r;
}
#endif

/// c0 + c1 x + c2 x^2 + ... by Horner's rule.
template <typename T, typename C, typename... Cs>
[[gnu::always_inline]] constexpr auto EvaluatePolynomial(const T &x, C c, Cs... rest) {
    if constexpr (sizeof...(rest) == 0)
        return c;
    else
        return c + x * EvaluatePolynomial(x, rest...);
}

/// e^x, relative error below 2e-7 for x in [-87, 88]; below that 1e-38 or less, above it 1e38.
/// By hand because the standard library has no exponential of SIMD registers: four at once cost
/// what one std::exp does.
template <int N>
[[gnu::always_inline]] inline Simd<float, N> Exp(const Simd<float, N> &of) {
    using V = Simd<float, N>;
    const V x = Min(Max(of, V(-87.3f)), V(88));
    constexpr float kShift = 0x1.8p23f;  // adding it leaves no bits for a fraction
    const V n = (x * 1.44269504f + kShift) - kShift;
    // x - n ln 2 with ln 2 in two parts, so that it keeps its digits.
    const V r = (x - n * 0.693145752f) - n * 1.42860677e-6f;
    // Own minimax fit of (e^r - 1 - r) / r^2 on |r| <= ln 2 / 2.
    const V q = EvaluatePolynomial(r, 0.499999935f, 0.166665207f, 0.0416683874f, 0.00836870983f,
                                   0.00138146131f);
    const V p = 1 + (r + r * r * q);
    return p * BitCast<float>((Convert<int32_t>(n) + 127) << 23);
}

/// Natural logarithm of normal positive numbers; error below 1.5e-7 plus 1.2e-7 of the result. By
/// hand for the same reason as Exp.
template <int N>
[[gnu::always_inline]] inline Simd<float, N> Log(const Simd<float, N> &x) {
    using V = Simd<float, N>;
    using Int = Simd<int32_t, N>;
    // x = m 2^e with m in [sqrt(1/2), sqrt(2)).
    const Int bits = BitCast<int32_t>(x) - 0x3f3504f3;
    const Int e = bits >> 23;
    const V m = BitCast<float>((bits & 0x007fffff) + 0x3f3504f3);
    // log m = 2 atanh s, its series: the first term left out is below 1e-9.
    const V s = (m - 1) / (m + 1), q = s * s;
    const V series = EvaluatePolynomial(q, 1.f, 1.f / 3, 1.f / 5, 1.f / 7, 1.f / 9);
    return 2 * s * series + Convert<float>(e) * 0.693147181f;
}

}  // namespace pbrt
