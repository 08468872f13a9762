#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pbrt/simd/trig.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

inline float SafeASin(float x) {
    return std::asin(std::clamp(x, -1.f, 1.f));
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

/// Bits in reverse order. U: uint32_t or UintX16.
template <typename U>
constexpr U ReverseBits32(U x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ff) << 8) | ((x >> 8) & 0x00ff00ff);
    x = ((x & 0x0f0f0f0f) << 4) | ((x >> 4) & 0x0f0f0f0f);
    x = ((x & 0x33333333) << 2) | ((x >> 2) & 0x33333333);
    return ((x & 0x55555555) << 1) | ((x >> 1) & 0x55555555);
}

}  // namespace pbrt
