#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

#include "pack.h"

namespace pbrt::feather {

// Most of the model is written once for a type V, which is a scalar or Lanes: sixteen scalars, one
// for each of sixteen surfaces and pairs of directions that are worked out side by side. Nothing
// passes from lane to lane. Here is what both kinds of V have in common.

inline constexpr int kLanes = 16;
// Unlike the registers of one evaluation (see kRegisterBytes): what is sixteen wide takes little
// more than half of the time in registers of 64 bytes and with AVX-512's instructions.
#if defined(__AVX512F__)
inline constexpr int kLaneBytes = 64;
#else
inline constexpr int kLaneBytes = kRegisterBytes;
#endif
template <std::floating_point T>
using Lanes = Pack<T, kLanes, kLaneBytes>;

/// What comparing two V gives: bool, or one for each lane.
template <class V>
using MaskOf = decltype(V() < V());

template <std::floating_point T>
T Select(bool first, T a, T b) {
    return first ? a : b;
}
template <std::floating_point T>
T Max(T a, T b) {
    return std::max(a, b);
}
template <std::floating_point T>
T Min(T a, T b) {
    return std::min(a, b);
}
template <std::floating_point T>
T Abs(T x) {
    return std::abs(x);
}
template <std::floating_point T>
T SignOf(T x) {
    return std::copysign(T(1), x);
}
/// x, or -x where y is below 0 or is -0.
template <std::floating_point T>
T MulSign(T x, T y) {
    return x * SignOf(y);
}
template <std::floating_point T>
T Sqrt(T x) {
    return std::sqrt(x);
}
template <std::floating_point T>
T Rint(T x) {
    return std::rint(x);
}
template <std::floating_point T>
T Sin(T x) {
    return std::sin(x);
}

/// One bit for each lane of a Lanes' mask, that of lane 0 lowest.
template <class Mask>
inline uint32_t BitsOf(const Mask &mask) {
    uint32_t bits = 0;
    constexpr int kWidth = kLanes * int(sizeof(mask.part[0])) / int(sizeof(mask));
    int first = 0;
    for (const auto &part : mask.part) {
#if defined(__AVX512F__)
        if constexpr (sizeof(part) == 64 && kWidth == 16)
            bits |= _cvtmask16_u32(_mm512_movepi32_mask(std::bit_cast<__m512i>(part))) << first;
        else if constexpr (sizeof(part) == 64)
            bits |= _cvtmask8_u32(_mm512_movepi64_mask(std::bit_cast<__m512i>(part))) << first;
        else
#endif
            for (int k = 0; k < kWidth; ++k)
                bits |= uint32_t(part[k] < 0) << (first + k);
        first += kWidth;
    }
    return bits;
}
inline bool Any(bool condition) {
    return condition;
}
template <class Mask>
requires std::is_class_v<Mask>
inline bool Any(const Mask &mask) {
    return BitsOf(mask) != 0;
}
inline bool All(bool condition) {
    return condition;
}
template <class Mask>
requires std::is_class_v<Mask>
inline bool All(const Mask &mask) {
    return BitsOf(mask) == (uint32_t(1) << kLanes) - 1;
}

/// 1 / x and 1 / sqrt(x) where the fourth digit does not count: Lanes of floats are within 2^-14 of
/// the value where the processor can, in a fifth of the time; all else is exact. x normal, > 0.
template <class V>
[[gnu::always_inline]] inline V QuickInverse(const V &x) {
    return 1 / x;
}
template <class V>
[[gnu::always_inline]] inline V QuickInverseRoot(const V &x) {
    return 1 / Sqrt(x);
}
#if defined(__AVX512F__)
[[gnu::always_inline]] inline Lanes<float> QuickInverse(const Lanes<float> &x) {
    return Lanes<float>::FromRegister(std::bit_cast<Lanes<float>::Register>(
        _mm512_maskz_rcp14_ps(0xffff, std::bit_cast<__m512>(x.part[0]))));
}
[[gnu::always_inline]] inline Lanes<float> QuickInverseRoot(const Lanes<float> &x) {
    return Lanes<float>::FromRegister(std::bit_cast<Lanes<float>::Register>(
        _mm512_maskz_rsqrt14_ps(0xffff, std::bit_cast<__m512>(x.part[0]))));
}
#endif

inline Lanes<double> ToDouble(const Lanes<double> &x) {
    return x;
}
inline Lanes<double> ToDouble(const Lanes<float> &x) {
    constexpr int kWidth = Lanes<double>::kWidth;
    typedef float Half __attribute__((vector_size(kWidth * sizeof(float))));
    Half halves[kLanes / kWidth];
    static_assert(sizeof(halves) == sizeof(x));
    x.Store(reinterpret_cast<float *>(halves));
    Lanes<double> wide;
    for (int i = 0; i < kLanes / kWidth; ++i)
        wide.part[i] = __builtin_convertvector(halves[i], Lanes<double>::Register);
    return wide;
}
template <std::floating_point T>
Lanes<T> FromDouble(const Lanes<double> &x) {
    if constexpr (std::is_same_v<T, double>) {
        return x;
    } else {
        constexpr int kWidth = Lanes<double>::kWidth;
        typedef float Half __attribute__((vector_size(kWidth * sizeof(float))));
        Half halves[kLanes / kWidth];
        for (int i = 0; i < kLanes / kWidth; ++i)
            halves[i] = __builtin_convertvector(x.part[i], Half);
        return Lanes<float>::At(reinterpret_cast<const float *>(halves));
    }
}
inline double ToDouble(float x) {
    return x;
}
inline double ToDouble(double x) {
    return x;
}
template <std::floating_point T>
T FromDouble(double x) {
    return T(x);
}

/// For each lane the number of another.
struct LaneIndex {
    Lanes<float>::IntRegister part[Lanes<float>::kRegisters];
    static LaneIndex At(const int32_t *from) {
        LaneIndex index;
        std::memcpy(index.part, from, sizeof(part));
        return index;
    }
    int operator[](int k) const { return part[k / Lanes<float>::kWidth][k % Lanes<float>::kWidth]; }
};

/// Whole numbers from 0 to 15.
template <std::floating_point T>
[[gnu::always_inline]] inline LaneIndex IndexOf(const Lanes<T> &numbers) {
    T from[kLanes];
    numbers.Store(from);
    int32_t to[kLanes];
    for (int k = 0; k < kLanes; ++k)
        to[k] = int32_t(from[k]);
    return LaneIndex::At(to);
}
/// Element l / shares of sixteen numbers in each lane l.
template <int shares>
[[gnu::always_inline]] inline LaneIndex Repeat(const int32_t *numbers) {
    int32_t to[kLanes];
    for (int l = 0; l < kLanes; ++l)
        to[l] = numbers[l / shares];
    return LaneIndex::At(to);
}

/// from[index] in each lane.
template <std::floating_point T>
[[gnu::always_inline]] inline Lanes<T> Permute(const Lanes<T> &from, const LaneIndex &index) {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<T, float>)
        return Lanes<T>::FromRegister(std::bit_cast<typename Lanes<T>::Register>(
            _mm512_maskz_permutexvar_ps(0xffff, std::bit_cast<__m512i>(index.part[0]),
                                        std::bit_cast<__m512>(from.part[0]))));
#endif
    T taken[kLanes];
    for (int k = 0; k < kLanes; ++k)
        taken[k] = from[index[k]];
    return Lanes<T>::At(taken);
}

// Structs of several V have Fields(), which ties them all.

/// Lane k of each field becomes the one scalar of the other tuple.
template <class... Vs, class... Ts>
void SetLane(int k, const std::tuple<Vs &...> &fields, const std::tuple<Ts &...> &ones) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        (std::get<i>(fields).Set(k, std::get<i>(ones)), ...);
    }
    (std::index_sequence_for<Vs...>());
}
template <class... Vs>
void TakeLanes(const std::tuple<Vs &...> &fields, const std::tuple<const Vs &...> &from,
               const LaneIndex &index) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        ((std::get<i>(fields) = Permute(std::get<i>(from), index)), ...);
    }
    (std::index_sequence_for<Vs...>());
}

}  // namespace pbrt::feather
