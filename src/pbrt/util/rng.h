#pragma once

#include "pbrt/util/hash.h"

namespace pbrt {

/// Pseudo-random numbers by hashing a counter (SplitMix64: Steele, Lea, Flood 2014): the i-th
/// number depends on the seed and i alone. Period 2^64.
class Rng {
  public:
    explicit Rng(uint64_t seed = 0) : state(Mix64(seed ^ kGolden64)) {}

    uint64_t Next64() { return Mix64(state += kGolden64); }
    uint32_t Next32() { return uint32_t(Next64() >> 32); }
    /// In [0, 1), 24 bits.
    float Uniform() { return ToUnitFloat(Next32()); }
    Point2f Uniform2D() {
        const uint64_t bits = Next64();
        return {ToUnitFloat(uint32_t(bits >> 32)), ToUnitFloat(uint32_t(bits))};
    }
    /// In [0, n), n > 0; bias at most n / 2^32.
    uint32_t Below(uint32_t n) { return uint32_t(uint64_t(Next32()) * n >> 32); }
    /// As if `count` numbers had been drawn.
    void Skip(uint64_t count) { state += count * kGolden64; }

  private:
    uint64_t state;
};

}  // namespace pbrt
