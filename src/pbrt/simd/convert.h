#pragma once

#include <bit>
#include <cstdint>
#include <utility>

#include "simd.h"

namespace pbrt {

namespace registers {

template <class R, int first, int... i>
[[gnu::always_inline]] inline auto Slice(R a, std::integer_sequence<int, i...>) {
    return __builtin_shufflevector(a, a, (first + i)...);
}
template <class R, int... i>
[[gnu::always_inline]] inline auto Concatenate(R a, R b, std::integer_sequence<int, i...>) {
    return __builtin_shufflevector(a, b, i...);
}

/// The elements of x as those of R, which holds as many.
template <class R, class From>
[[gnu::always_inline]] inline R ConvertRegister(From x) {
#if defined(__AVX512F__)
    if constexpr (kIs<R, double, 64> && kIs<From, float, 32>)
        return R(_mm512_maskz_cvtps_pd(0xff, __m256(x)));
#endif
#if defined(__AVX__)
    if constexpr (kIs<R, double, 32> && kIs<From, float, 16>) return R(_mm256_cvtps_pd(__m128(x)));
#endif
    return __builtin_convertvector(x, R);
}

/// Register k of To, each number of which is that of From.
template <class To, class From, int k>
[[gnu::always_inline]] inline typename To::Register ConvertedPart(const From &a) {
    using Register = typename To::Register;
    constexpr int width = To::kWidth;
    if constexpr (From::kWidth == width) {
        return ConvertRegister<Register>(a.part[k]);
    } else if constexpr (From::kWidth == 2 * width) {
        const auto half = Slice<typename From::Register, (k % 2) * width>(
            a.part[k / 2], std::make_integer_sequence<int, width>());
        return ConvertRegister<Register>(half);
    } else {
        static_assert(2 * From::kWidth == width);
        typedef typename To::Scalar Half
            __attribute__((vector_size(width / 2 * sizeof(typename To::Scalar))));
        return Concatenate(ConvertRegister<Half>(a.part[2 * k]),
                           ConvertRegister<Half>(a.part[2 * k + 1]),
                           std::make_integer_sequence<int, width>());
    }
}

}  // namespace registers

/// Each number as the nearest U; floats towards 0 as integers, which must hold them.
template <class U, class T, int N>
[[gnu::always_inline]] inline Simd<U, N> Convert(const Simd<T, N> &a) {
    if constexpr (std::is_same_v<U, T>) {
        return a;
    } else {
        Simd<U, N> to;
        [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
            ((to.part[k] = registers::ConvertedPart<Simd<U, N>, Simd<T, N>, k>(a)), ...);
        }
        (std::make_integer_sequence<int, Simd<U, N>::kRegisters>());
        return to;
    }
}
template <class U, class T>
requires std::is_arithmetic_v<T>
constexpr U Convert(T a) {
    return U(a);
}

/// Numbers of the same size with the same bits.
template <class U, class T, int N>
requires(sizeof(U) == sizeof(T))
    [[gnu::always_inline]] inline Simd<U, N> BitCast(const Simd<T, N> &a) {
    using Register = typename Simd<U, N>::Register;
    return registers::Each<Simd<U, N>>([](auto x) { return Register(x); }, a);
}
template <class U, class T>
requires(std::is_arithmetic_v<T> && sizeof(U) == sizeof(T)) constexpr U BitCast(T a) {
    return std::bit_cast<U>(a);
}

/// The same mask for numbers of 4 or 8 bytes.
template <int Bytes, int From, int N>
[[gnu::always_inline]] inline SimdMask<Bytes, N> ConvertMask(const SimdMask<From, N> &mask) {
    using To = SimdMask<Bytes, N>;
    using Integers = Simd<typename SimdMask<From, N>::Integer, N>;
    const auto as =
        Convert<typename To::Integer>(registers::Each<Integers>([](auto x) { return x; }, mask));
    return registers::Each<To>([](auto x) { return x; }, as);
}

// Of numbers below 2^31, which are converted as if they had a sign: to and from numbers without one
// there are instructions only with AVX-512.

/// Towards 0.
[[gnu::always_inline]] inline UintX16 Truncate(const FloatX16 &a) {
    return BitCast<uint32_t>(Convert<int32_t>(a));
}
inline uint32_t Truncate(float a) {
    return uint32_t(int32_t(a));
}
[[gnu::always_inline]] inline FloatX16 ToFloat(const UintX16 &a) {
    return Convert<float>(BitCast<int32_t>(a));
}

/// 64 bits from two halves, and back.
[[gnu::always_inline]] inline Uint64X16 Join(const UintX16 &low, const UintX16 &high) {
    return Convert<uint64_t>(low) | (Convert<uint64_t>(high) << 32);
}
[[gnu::always_inline]] inline UintX16 LowHalf(const Uint64X16 &a) {
    return Convert<uint32_t>(a);
}
[[gnu::always_inline]] inline UintX16 HighHalf(const Uint64X16 &a) {
    return Convert<uint32_t>(a >> 32);
}

}  // namespace pbrt
