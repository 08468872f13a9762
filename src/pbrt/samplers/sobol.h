#pragma once

#include <cstdint>

#include "pbrt/util/hash.h"
#include "pbrt/util/math.h"

namespace pbrt {

// The (0,2)-sequence of the first two Sobol' dimensions. Coordinates are handled as 32 binary
// digits in *reverse*: bit 0 is the digit after the point. In this order the first coordinate of
// point i is i itself, and nested scrambling becomes ordinary arithmetic with carries. U: uint32_t,
// or several of them side by side.

/// Second coordinate of point i, reversed. Its generator matrix is Pascal's triangle modulo 2:
/// digit r is the sum of the index digits whose place, written in binary, contains r (Lucas), hence
/// five steps of a butterfly instead of a table.
template <typename U>
constexpr U SobolYReversed(U i) {
    i ^= (i >> 1) & 0x55555555;
    i ^= (i >> 2) & 0x33333333;
    i ^= (i >> 4) & 0x0f0f0f0f;
    i ^= (i >> 8) & 0x00ff00ff;
    return i ^ (i >> 16);
}

/// Nested uniform ("Owen") scrambling of a reversed number, approximated by a hash in which no bit
/// reaches a lower one (Laine and Karras 2011; this form and its constants: Vegdahl 2021, "Building
/// a Better LK Hash"). `seed` must be well mixed.
template <typename U>
constexpr U FastOwenReversed(U v, U seed) {
    v ^= v * 0x3d20adea;
    v += seed;
    v *= (seed >> 16) | 1;
    v ^= v * 0x05526c56;
    return v ^ (v * 0x53a22864);
}

/// Nested uniform scrambling of a reversed number: every digit is flipped by a hash of those before
/// it. Exact but for the hash; 30 times slower than FastOwenReversed.
template <typename U>
constexpr U OwenReversed(U v, U seed) {
    U flips = Mix32(seed) & 1;
    for (int digit = 1; digit < 32; ++digit) {
        const U before = v & ((uint32_t(1) << digit) - 1);
        // The digit's place goes into the hash as the bit above those before it.
        const U node = before | (uint32_t(1) << digit);
        flips |= (Mix32(Mix32(node) + seed) & 1) << digit;
    }
    return v ^ flips;
}

}  // namespace pbrt
