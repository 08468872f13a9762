#pragma once

#include <vector>

#include "pbrt/util/vecmath_simd.h"

namespace pbrt {

// Radical inverses: the digits of a number in a prime base, mirrored at the point. U: uint32_t or
// UintX16.

/// Quotient and remainder by a fixed odd number below 2^11, of numbers below 2^31.
class OddDivisor {
  public:
    explicit OddDivisor(uint32_t value);

    uint32_t Value() const { return value; }
    /// Exact: the factor is too large by less than 2^-31 of itself (Granlund and Montgomery 1994).
    template <typename U>
    U Quotient(const U &i) const {
        return Convert<uint32_t>((Convert<uint64_t>(i) * factor) >> shift);
    }
    template <typename U>
    U Remainder(const U &i) const {
        return i - Quotient(i) * value;
    }

  private:
    uint32_t value;
    int shift;
    uint64_t factor;
};

/// The first primes from 3 on, each with what its radical inverses need: a random permutation of
/// its digits for each of their places.
class RadicalInverses {
  public:
    /// As many digits as a float can tell.
    struct Base {
        OddDivisor divide;
        int digits;
        float scale;          ///< the prime to the power of -digits
        size_t permutations;  ///< where those of the first digit start
    };

    /// `count` primes, up to 1619; a few milliseconds and two megabytes for them all.
    RadicalInverses(int count, uint64_t seed);

    /// In [0, 1). randomize(base, place, digit) returns what becomes of a digit; places count from
    /// the point. Rounded three times. i < 2^31.
    template <typename U, typename Randomize>
    auto operator()(int which, U i, const Randomize &randomize) const {
        const Base &base = bases[size_t(which)];
        U mirrored{};
        for (int place = 0; place < base.digits; ++place) {
            const U rest = base.divide.Quotient(i);
            const U digit = randomize(base, place, U(i - rest * base.divide.Value()));
            mirrored = mirrored * base.divide.Value() + digit;
            i = rest;
        }
        return Min(FloatOf(mirrored) * base.scale, OneMinusEpsilon);
    }
    /// The digit's image under the permutation of its place.
    uint32_t Permuted(const Base &base, int place, uint32_t digit) const {
        return PermutationAt(base, place)[digit];
    }
    UintX16 Permuted(const Base &base, int place, const UintX16 &digit) const {
        return Gather(PermutationAt(base, place), digit);
    }

  private:
    const uint32_t *PermutationAt(const Base &base, int place) const {
        return &images[base.permutations + size_t(place) * base.divide.Value()];
    }
    static float FloatOf(uint32_t i) { return float(i); }
    /// As that of one number: the halves are exact, and their sum is rounded once.
    static FloatX16 FloatOf(const UintX16 &i) {
        return ToFloat(i >> 8) * 256.f + ToFloat(i & 255u);
    }

    std::vector<Base> bases;
    std::vector<uint32_t> images;
};

}  // namespace pbrt
