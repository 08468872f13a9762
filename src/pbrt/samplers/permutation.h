#pragma once

#include <bit>
#include <cstdint>

#include "pbrt/util/check.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

/// A bijection of the numbers of `bits` bits, chosen by a well-mixed key: three rounds of addition,
/// i ^= i * even (each bit reaches the higher ones) and i ^= i >> half (the lower ones).
/// Randomness: if the elements are interleaved out to two dimensions by two keys, the variance of
/// the product of two Walsh functions is that of random permutations, n / (n - 1), to within 20 %
/// for n = 4 to 64; one nested shuffle alone is wrong by a factor n. U: uint32_t or UintX16.
class BitPermutation {
  public:
    explicit BitPermutation(int bits)
        : mask(uint32_t((uint64_t(1) << bits) - 1)), shift((bits + 1) / 2) {}

    template <typename U>
    U operator()(U i, U key) const {
        // Any congruential step gives the rounds different keys.
        const U key2 = key * 0x9e3779b9 + 0x7f4a7c15;
        const U key3 = key2 * 0x9e3779b9 + 0x7f4a7c15;
        return (Round(Round(Round(i, key), key2), key3) + (key >> 8)) & mask;
    }

  private:
    template <typename U>
    U Round(U i, U key) const {
        i += key >> 16;
        i = (i ^ (i * (key & ~1u))) & mask;
        return i ^ (i >> shift);
    }
    uint32_t mask;
    int shift;
};

/// A random permutation of {0, ..., n - 1}, 1 <= n <= 2^24: a bijection of the next power of two,
/// repeated until it hits the set ("cycle walking", Black and Rogaway 2002), and a rotation, which
/// makes each place as likely, up to 2^20 to within a sixteenth. U: uint32_t or UintX16.
class Permutation {
  public:
    explicit Permutation(uint32_t n) : n(n), bits(std::bit_width(n - 1)) {}

    uint32_t Size() const { return n; }
    /// Image of i < n under the permutation chosen by two independent keys.
    template <typename U>
    U operator()(U i, U walkKey, U turnKey) const {
        i = bits(i, walkKey);
        while (Any(i >= n))
            i = Select(i < n, i, bits(i, walkKey));
        const U turned = i + Truncate(ToUnitFloat(turnKey) * float(int32_t(n)));
        return Select(turned >= n, turned - n, turned);
    }

  private:
    uint32_t n;
    BitPermutation bits;
};

}  // namespace pbrt
