#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

// How the kit is built, and why. This is the only place that tells of compilers.
//
// A vector of N numbers is a struct of as many machine registers as it needs, never one wide GNU
// vector: g++ 12 takes vectors that exceed the machine's registers apart into scalars.
//
// Every function is inlined by force. In large translation units compilers stop inlining, and
// structs of registers then pass through memory. For the same reason nothing here is a loop over an
// array of registers or elements: what is indexed by a variable lives in memory. Structs of several
// vectors are best made in place and passed by reference; g++ copies them through memory.
//
// Intrinsics are named where g++ 12 does not find the instruction: it turns min and max into
// a comparison and a blend and converts float to double by halves, and it calls functions for roots
// and roundings unless errno and traps are switched off. The AVX-512 ones are the masked forms with
// a mask that always holds: others start from an undefined register, which g++ 12 reports
// as uninitialised.
//
// Registers are as wide as the machine has them. What one evaluation needs (up to eight floats) is
// thus at most 32 bytes wide, also with AVX-512: 64-byte instructions lower the clock of all that
// runs beside them, and one pair of directions gains nothing by them.

namespace pbrt {

/// Bytes of the widest vector register.
#if defined(__AVX512F__)
inline constexpr int kRegisterBytes = 64;
#elif defined(__AVX__)
inline constexpr int kRegisterBytes = 32;
#else
inline constexpr int kRegisterBytes = 16;
#endif

/// Functions of one register R of numbers T.
namespace registers {

/// Number of elements of `bytes` bytes, of N in all, that one register holds.
constexpr int Width(int bytes, int N) {
    return std::min(N, kRegisterBytes / bytes);
}

/// The register with f(0), f(1), ... f(sizeof...(i) - 1).
template <class R, class F, int... i>
[[gnu::always_inline]] constexpr R Generate(const F &f, std::integer_sequence<int, i...>) {
    return R{f(i)...};
}

/// operation(registers of the arguments...) for each of Result's registers.
template <class Result, class Operation, class... Arguments>
[[gnu::always_inline]] inline Result Each(Operation operation, const Arguments &...arguments) {
    constexpr int n = Result::kRegisters;
    static_assert(n == 1 || n == 2 || n == 4 || n == 8);
    Result result;
    result.part[0] = operation(arguments.part[0]...);
    if constexpr (n > 1) result.part[1] = operation(arguments.part[1]...);
    if constexpr (n > 2) {
        result.part[2] = operation(arguments.part[2]...);
        result.part[3] = operation(arguments.part[3]...);
    }
    if constexpr (n > 4) {
        result.part[4] = operation(arguments.part[4]...);
        result.part[5] = operation(arguments.part[5]...);
        result.part[6] = operation(arguments.part[6]...);
        result.part[7] = operation(arguments.part[7]...);
    }
    return result;
}

template <class R>
using Element = std::remove_cvref_t<decltype(std::declval<R>()[0])>;
/// R holds `bytes` bytes of T.
template <class R, class T, int bytes>
inline constexpr bool kIs = std::is_same_v<Element<R>, T> && sizeof(R) == bytes;

/// a < b ? a : b.
template <class R>
[[gnu::always_inline]] inline R Min(R a, R b) {
#if defined(__AVX512F__)
    if constexpr (kIs<R, float, 64>) return R(_mm512_maskz_min_ps(0xffff, __m512(a), __m512(b)));
    if constexpr (kIs<R, double, 64>) return R(_mm512_maskz_min_pd(0xff, __m512d(a), __m512d(b)));
#endif
#if defined(__AVX__)
    if constexpr (kIs<R, float, 32>) return R(_mm256_min_ps(__m256(a), __m256(b)));
    if constexpr (kIs<R, double, 32>) return R(_mm256_min_pd(__m256d(a), __m256d(b)));
#endif
#if defined(__SSE2__)
    if constexpr (kIs<R, float, 16>) return R(_mm_min_ps(__m128(a), __m128(b)));
    if constexpr (kIs<R, double, 16>) return R(_mm_min_pd(__m128d(a), __m128d(b)));
#endif
    return a < b ? a : b;
}
/// a > b ? a : b.
template <class R>
[[gnu::always_inline]] inline R Max(R a, R b) {
#if defined(__AVX512F__)
    if constexpr (kIs<R, float, 64>) return R(_mm512_maskz_max_ps(0xffff, __m512(a), __m512(b)));
    if constexpr (kIs<R, double, 64>) return R(_mm512_maskz_max_pd(0xff, __m512d(a), __m512d(b)));
#endif
#if defined(__AVX__)
    if constexpr (kIs<R, float, 32>) return R(_mm256_max_ps(__m256(a), __m256(b)));
    if constexpr (kIs<R, double, 32>) return R(_mm256_max_pd(__m256d(a), __m256d(b)));
#endif
#if defined(__SSE2__)
    if constexpr (kIs<R, float, 16>) return R(_mm_max_ps(__m128(a), __m128(b)));
    if constexpr (kIs<R, double, 16>) return R(_mm_max_pd(__m128d(a), __m128d(b)));
#endif
    return a > b ? a : b;
}

/// f(element) for each.
template <class R, class F>
[[gnu::always_inline]] inline R Map(const F &f, R x) {
    constexpr int n = int(sizeof(R) / sizeof(Element<R>));
    return Generate<R>(
        [&](int i) __attribute__((always_inline)) { return f(x[i]); },
        std::make_integer_sequence<int, n>());
}

template <class R>
[[gnu::always_inline]] inline R Sqrt(R x) {
#if defined(__AVX512F__)
    if constexpr (kIs<R, float, 64>) return R(_mm512_maskz_sqrt_ps(0xffff, __m512(x)));
    if constexpr (kIs<R, double, 64>) return R(_mm512_maskz_sqrt_pd(0xff, __m512d(x)));
#endif
#if defined(__AVX__)
    if constexpr (kIs<R, float, 32>) return R(_mm256_sqrt_ps(__m256(x)));
    if constexpr (kIs<R, double, 32>) return R(_mm256_sqrt_pd(__m256d(x)));
#endif
#if defined(__SSE2__)
    if constexpr (kIs<R, float, 16>) return R(_mm_sqrt_ps(__m128(x)));
    if constexpr (kIs<R, double, 16>) return R(_mm_sqrt_pd(__m128d(x)));
#endif
    return Map([](auto e) { return std::sqrt(e); }, x);
}

/// kMode: how x86's instructions round: 8 to nearest, of two the even one; 9 down.
template <int kMode, class R>
[[gnu::always_inline]] inline R RoundBy(R x) {
#if defined(__AVX512F__)
    if constexpr (kIs<R, float, 64>) return R(_mm512_maskz_roundscale_ps(0xffff, __m512(x), kMode));
    if constexpr (kIs<R, double, 64>) return R(_mm512_maskz_roundscale_pd(0xff, __m512d(x), kMode));
#endif
#if defined(__AVX__)
    if constexpr (kIs<R, float, 32>) return R(_mm256_round_ps(__m256(x), kMode));
    if constexpr (kIs<R, double, 32>) return R(_mm256_round_pd(__m256d(x), kMode));
#endif
#if defined(__SSE4_1__)
    if constexpr (kIs<R, float, 16>) return R(_mm_round_ps(__m128(x), kMode));
    if constexpr (kIs<R, double, 16>) return R(_mm_round_pd(__m128d(x), kMode));
#endif
    return Map([](auto e) { return kMode == 9 ? std::floor(e) : std::rint(e); }, x);
}

/// One bit per element, the first lowest; each element of x is -1 or 0.
template <class R>
[[gnu::always_inline]] inline uint32_t Bits(R x) {
#if defined(__AVX512F__)
    if constexpr (kIs<R, int32_t, 64>) return _mm512_test_epi32_mask(__m512i(x), __m512i(x));
    if constexpr (kIs<R, int64_t, 64>) return _mm512_test_epi64_mask(__m512i(x), __m512i(x));
#endif
#if defined(__AVX__)
    if constexpr (kIs<R, int32_t, 32>) return uint32_t(_mm256_movemask_ps(__m256(x)));
    if constexpr (kIs<R, int64_t, 32>) return uint32_t(_mm256_movemask_pd(__m256d(x)));
#endif
#if defined(__SSE2__)
    if constexpr (kIs<R, int32_t, 16>) return uint32_t(_mm_movemask_ps(__m128(x)));
    if constexpr (kIs<R, int64_t, 16>) return uint32_t(_mm_movemask_pd(__m128d(x)));
#endif
    uint32_t bits = 0;
    for (int i = 0; i < int(sizeof(R) / sizeof(Element<R>)); ++i)
        bits |= uint32_t(x[i] < 0) << i;
    return bits;
}

}  // namespace registers
}  // namespace pbrt
