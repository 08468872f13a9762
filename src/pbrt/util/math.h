#pragma once

#include <algorithm>
#include <cstdint>

#include "pbrt/util/wide.h"

namespace pbrt {

/// c0 + c1 x + c2 x^2 + ... by Horner's rule.
template <typename T, typename C, typename... Cs>
constexpr auto EvaluatePolynomial(T x, C c, Cs... rest) {
    if constexpr (sizeof...(rest) == 0)
        return c;
    else
        return c + x * EvaluatePolynomial(x, rest...);
}

inline float SafeASin(float x) {
    return std::asin(std::clamp(x, -1.f, 1.f));
}

template <AnyFloat T>
struct SinCosT {
    T sin, cos;
};
using SinCos = SinCosT<float>;

/// Sine and cosine of r quarter turns, |r| <= 1/2. Absolute error below 1.5e-7. By hand because
/// sampling warps know their quadrant and need no more: a third of the time of sinf and cosf.
/// Polynomials in r^2: own minimax fit.
template <AnyFloat T>
inline SinCosT<T> SinCosQuarters(T r) {
    const T s = r * r;
    return {
        r * EvaluatePolynomial(s, 1.57079632f, -0.645963479f, 0.0796802281f, -0.00460217700f),
        1 + s * EvaluatePolynomial(s, -1.23370055f, 0.253669410f, -0.0208615297f, 0.000906743541f)};
}

/// Sine and cosine of `turns` times 2 pi, |turns| <= 2^20; error as above: the reduction is exact.
template <AnyFloat T>
inline SinCosT<T> SinCosTurns(T turns) {
    const T quarter = Floor(4 * turns + 0.5f);
    const SinCosT<T> part = SinCosQuarters(T(4 * turns - quarter));
    const auto q = ToInt(quarter);
    const auto swapped = (q & 1) != 0;
    const T sin = Select(swapped, part.cos, part.sin), cos = Select(swapped, part.sin, part.cos);
    return {Select((q & 2) != 0, -sin, sin), Select(((q + 1) & 2) != 0, -cos, cos)};
}

/// Bits 0 to 15 of x moved to the even places.
constexpr uint32_t SpreadBits(uint32_t x) {
    x = (x | (x << 8)) & 0x00ff00ff;
    x = (x | (x << 4)) & 0x0f0f0f0f;
    x = (x | (x << 2)) & 0x33333333;
    return (x | (x << 1)) & 0x55555555;
}
/// Morton code: the bits of x and y (16 each) in turns, x lowest.
constexpr uint32_t EncodeMorton2(uint32_t x, uint32_t y) {
    return SpreadBits(x & 0xffff) | (SpreadBits(y & 0xffff) << 1);
}

/// Bits in reverse order. U: uint32_t, or several of them side by side.
template <typename U>
constexpr U ReverseBits32(U x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ff) << 8) | ((x >> 8) & 0x00ff00ff);
    x = ((x & 0x0f0f0f0f) << 4) | ((x >> 4) & 0x0f0f0f0f);
    x = ((x & 0x33333333) << 2) | ((x >> 2) & 0x33333333);
    return ((x & 0x55555555) << 1) | ((x >> 1) & 0x55555555);
}

}  // namespace pbrt
