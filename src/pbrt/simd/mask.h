#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "registers.h"

namespace pbrt {

/// Result of comparing two vectors: true or false for each of N elements of that many bytes.
template <int Bytes, int N>
class SimdMask {
  public:
    using Integer = std::conditional_t<Bytes == 4, int32_t, int64_t>;
    static constexpr int kSize = N, kWidth = registers::Width(Bytes, N), kRegisters = N / kWidth;
    typedef Integer Register __attribute__((vector_size(kWidth * Bytes)));
    Register part[kRegisters];  ///< all bits of an element are set, or none

    SimdMask() = default;
    [[gnu::always_inline]] SimdMask(bool all) {
        *this =
            registers::Each<SimdMask>([all](auto zero) { return zero - Integer(all); }, SimdMask{});
    }
    /// The lowest N bits, that of element 0 lowest.
    [[gnu::always_inline]] static SimdMask FromBits(uint32_t bits) {
        return FromBits(bits, std::make_integer_sequence<int, kRegisters>());
    }
    [[gnu::always_inline]] bool operator[](int k) const {
        return part[unsigned(k) / kWidth][unsigned(k) % kWidth] != 0;
    }
    /// N integers, -1 for true and 0 for false.
    [[gnu::always_inline]] void Store(Integer *to) const { std::memcpy(to, part, sizeof part); }

    [[gnu::always_inline]] friend SimdMask operator&(const SimdMask &a, const SimdMask &b) {
        return registers::Each<SimdMask>([](auto x, auto y) { return x & y; }, a, b);
    }
    [[gnu::always_inline]] friend SimdMask operator|(const SimdMask &a, const SimdMask &b) {
        return registers::Each<SimdMask>([](auto x, auto y) { return x | y; }, a, b);
    }
    [[gnu::always_inline]] friend SimdMask operator!=(const SimdMask &a, const SimdMask &b) {
        return registers::Each<SimdMask>([](auto x, auto y) { return x ^ y; }, a, b);
    }
    [[gnu::always_inline]] friend SimdMask operator==(const SimdMask &a, const SimdMask &b) {
        return registers::Each<SimdMask>([](auto x, auto y) { return ~(x ^ y); }, a, b);
    }
    [[gnu::always_inline]] friend SimdMask operator!(const SimdMask &a) {
        return registers::Each<SimdMask>([](auto x) { return ~x; }, a);
    }
    [[gnu::always_inline]] SimdMask &operator&=(const SimdMask &b) { return *this = *this & b; }
    [[gnu::always_inline]] SimdMask &operator|=(const SimdMask &b) { return *this = *this | b; }

  private:
    template <int... k>
    [[gnu::always_inline]] static SimdMask FromBits(uint32_t bits,
                                                    std::integer_sequence<int, k...>) {
        constexpr Register kBit = registers::Generate<Register>(
            [](int i) { return Integer(1) << i; }, std::make_integer_sequence<int, kWidth>());
        SimdMask mask;
        ((mask.part[k] = (kBit & Integer(bits >> (k * kWidth))) != 0), ...);
        return mask;
    }
};

/// One bit per element of a mask, that of element 0 lowest.
using LaneBits = uint32_t;

template <int Bytes, int N>
[[gnu::always_inline]] inline LaneBits BitsOf(const SimdMask<Bytes, N> &mask) {
    using Mask = SimdMask<Bytes, N>;
    return [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
        return ((registers::Bits(mask.part[k]) << (k * Mask::kWidth)) | ...);
    }
    (std::make_integer_sequence<int, Mask::kRegisters>());
}
template <int Bytes, int N>
[[gnu::always_inline]] inline bool Any(const SimdMask<Bytes, N> &mask) {
    return BitsOf(mask) != 0;
}
template <int Bytes, int N>
[[gnu::always_inline]] inline bool All(const SimdMask<Bytes, N> &mask) {
    return BitsOf(mask) == LaneBits((uint64_t(1) << N) - 1);
}
// The same for one condition.
constexpr bool Any(bool condition) {
    return condition;
}
constexpr bool All(bool condition) {
    return condition;
}

/// The elements 0 to n - 1 of `size`.
constexpr LaneBits FirstLanes(int n, int size = 16) {
    return LaneBits((uint64_t(1) << std::min(n, size)) - 1);
}
/// Calls f(k) for each bit that is set, from the lowest.
template <typename F>
inline void ForEachLane(LaneBits lanes, F f) {
    for (; lanes != 0; lanes &= lanes - 1)
        f(std::countr_zero(lanes));
}

}  // namespace pbrt
