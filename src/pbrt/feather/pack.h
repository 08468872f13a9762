#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace pbrt::feather {

// Not AVX-512's 64 bytes: those lower the clock of all that runs beside them, and TRT with 8 points
// takes a fifth longer.
#if defined(__AVX__)
inline constexpr int kRegisterBytes = 32;
#else
inline constexpr int kRegisterBytes = 16;
#endif

/// n scalars (a power of two; 16 bytes at least) in as many vector registers, of `bytes` at most,
/// as they need. Operators and functions go element by element; a scalar counts as n equal ones.
///
/// Not one wide vector type, which g++ takes apart into scalars where it exceeds the machine's
/// registers. All is inlined by force: in a large translation unit compilers would stop, and packs
/// would pass through memory.
template <std::floating_point T, int n, int bytes = kRegisterBytes>
struct Pack {
    static constexpr int kSize = n;
    static constexpr int kWidth = std::min(n, bytes / int(sizeof(T)));
    static constexpr int kRegisters = n / kWidth;
    using Integer = std::conditional_t<sizeof(T) == sizeof(int32_t), int32_t, int64_t>;
    typedef T Register __attribute__((vector_size(kWidth * sizeof(T))));
    typedef Integer IntRegister __attribute__((vector_size(kWidth * sizeof(T))));

    Register part[kRegisters];

    /// Per element all bits or none.
    struct Mask {
        IntRegister part[kRegisters];
        [[gnu::always_inline]] friend Mask operator&(const Mask &a, const Mask &b) {
            return Each<Mask>([](auto x, auto y) { return x & y; }, a, b);
        }
        [[gnu::always_inline]] friend Mask operator|(const Mask &a, const Mask &b) {
            return Each<Mask>([](auto x, auto y) { return x | y; }, a, b);
        }
        [[gnu::always_inline]] friend Mask operator!(const Mask &a) {
            return Each<Mask>([](auto x) { return ~x; }, a);
        }
    };

    Pack() = default;
    [[gnu::always_inline]] Pack(T x) {
        *this = Each<Pack>([x](auto zero) { return x - zero; }, Pack{});
    }
    /// The n scalars there.
    [[gnu::always_inline]] static Pack At(const T *from) {
        Pack a;
        std::memcpy(a.part, from, sizeof(part));
        return a;
    }
    [[gnu::always_inline]] void Store(T *to) const { std::memcpy(to, part, sizeof(part)); }
    /// All n scalars, where one register holds them.
    [[gnu::always_inline]] static Pack FromRegister(Register only) requires(kRegisters == 1) {
        Pack a;
        a.part[0] = only;
        return a;
    }
    /// True for the first n / 2 elements.
    [[gnu::always_inline]] static Mask FirstHalf() {
        T index[n];
        for (int k = 0; k < n; ++k)
            index[k] = T(k);
        return At(index) < Pack(T(n / 2));
    }
    [[gnu::always_inline]] T operator[](int k) const { return part[k / kWidth][k % kWidth]; }
    [[gnu::always_inline]] void Set(int k, T x) { part[k / kWidth][k % kWidth] = x; }

    [[gnu::always_inline]] friend Pack operator+(const Pack &a, const Pack &b) {
        return Each<Pack>([](auto x, auto y) { return x + y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator-(const Pack &a, const Pack &b) {
        return Each<Pack>([](auto x, auto y) { return x - y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator*(const Pack &a, const Pack &b) {
        return Each<Pack>([](auto x, auto y) { return x * y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator/(const Pack &a, const Pack &b) {
        return Each<Pack>([](auto x, auto y) { return x / y; }, a, b);
    }
    [[gnu::always_inline]] friend Pack operator-(const Pack &a) {
        return Each<Pack>([](auto x) { return -x; }, a);
    }
    [[gnu::always_inline]] friend Mask operator<(const Pack &a, const Pack &b) {
        return Each<Mask>([](auto x, auto y) { return x < y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator>(const Pack &a, const Pack &b) { return b < a; }
    [[gnu::always_inline]] friend Mask operator>=(const Pack &a, const Pack &b) {
        return Each<Mask>([](auto x, auto y) { return x >= y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator<=(const Pack &a, const Pack &b) { return b >= a; }
    [[gnu::always_inline]] friend Mask operator==(const Pack &a, const Pack &b) {
        return Each<Mask>([](auto x, auto y) { return x == y; }, a, b);
    }

    /// m ? a : b
    [[gnu::always_inline]] friend Pack Select(const Mask &m, const Pack &a, const Pack &b) {
        return Each<Pack>([](auto first, auto x, auto y) { return first ? x : y; }, m, a, b);
    }
    [[gnu::always_inline]] friend Pack Max(const Pack &a, const Pack &b) {
#if defined(__AVX512F__)
        if constexpr (sizeof(Register) == 64 && sizeof(T) == 4)  // g++ 12 compares and blends
            return Each<Pack>(
                [](auto x, auto y) __attribute__((always_inline)) {
                    return Register(_mm512_maskz_max_ps(0xffff, __m512(x), __m512(y)));
                },
                a, b);
#endif
        return Select(a > b, a, b);
    }
    [[gnu::always_inline]] friend Pack Min(const Pack &a, const Pack &b) {
        return Select(b > a, a, b);
    }
    [[gnu::always_inline]] friend Pack Abs(const Pack &a) {
        return Each<Pack>(
            [](auto x) { return Register(IntRegister(x) & ~IntRegister(-Register{})); }, a);
    }
    /// x, or -x where y is below 0 or is -0.
    [[gnu::always_inline]] friend Pack MulSign(const Pack &x, const Pack &y) {
        return Each<Pack>(
            [](auto a, auto b) {
                return Register(IntRegister(a) ^ (IntRegister(b) & IntRegister(-Register{})));
            },
            x, y);
    }
    /// 1 or -1, as the sign bit says.
    [[gnu::always_inline]] friend Pack SignOf(const Pack &a) {
        return Each<Pack>(
            [](auto x) {
                return Register((IntRegister(x) & IntRegister(-Register{})) |
                                IntRegister(Register{} + 1));
            },
            a);
    }
    [[gnu::always_inline]] friend Pack Sqrt(const Pack &a) {
        return MapElements([](T e) { return std::sqrt(e); }, a);
    }
    [[gnu::always_inline]] friend Pack Rint(const Pack &a) {
        return MapElements([](T e) { return std::rint(e); }, a);
    }
    [[gnu::always_inline]] friend Pack Sin(const Pack &a) {
        return MapElements([](T e) { return std::sin(e); }, a);
    }

    /// Element k of the result is element from(k) of a. What goes into one register comes from one
    /// register; `from` is a constexpr lambda without captures.
    template <class From>
    [[gnu::always_inline]] friend Pack Permuted(const Pack &a, From from) {
        return PermutedBy(a, from, kIndices);
    }
    /// a, and a again.
    [[gnu::always_inline]] friend Pack<T, 2 * n, bytes> Doubled(const Pack &a) {
        using Twice = Pack<T, 2 * n, bytes>;
        if constexpr (Twice::kWidth > kWidth)
            return Twice::FromRegister(TwiceARegister(a.part[0], kElements));
        else
            return DoubledBy(a, Twice::kIndices);
    }
    /// The first half plus the second.
    [[gnu::always_inline]] friend Pack<T, n / 2, bytes> Folded(const Pack &a) {
        using Half = Pack<T, n / 2, bytes>;
        if constexpr (kRegisters > 1)
            return FoldedBy(a, Half::kIndices);
        else
            return Half::FromRegister(FoldedRegister(a.part[0], Half::kElements));
    }

    static constexpr std::make_integer_sequence<int, kRegisters> kIndices{};
    static constexpr std::make_integer_sequence<int, kWidth> kElements{};

    // Nothing here is a loop: elements of arrays with indices known late stay in memory.

    /// operation(registers of the arguments...) for each register.
    template <class Result, class Operation, class... Arguments>
    [[gnu::always_inline]] static Result Each(Operation operation, const Arguments &...arguments) {
        return EachBy<Result>(kIndices, operation, arguments...);
    }
    template <class Result, int... k, class Operation, class... Arguments>
    [[gnu::always_inline]] static Result EachBy(std::integer_sequence<int, k...>,
                                                Operation operation,
                                                const Arguments &...arguments) {
        Result result;
        ((result.part[k] = AtRegister<k>(operation, arguments...)), ...);
        return result;
    }
    template <int k, class Operation, class... Arguments>
    [[gnu::always_inline]] static auto AtRegister(Operation operation,
                                                  const Arguments &...arguments) {
        return operation(arguments.part[k]...);
    }
    /// operation(element) for each element.
    template <class Operation>
    [[gnu::always_inline]] static Pack MapElements(Operation operation, const Pack &a) {
        return EachOfEachBy(operation, a, kIndices);
    }
    template <class Operation, int... k>
    [[gnu::always_inline]] static Pack EachOfEachBy(Operation operation, const Pack &a,
                                                    std::integer_sequence<int, k...>) {
        Pack result;
        ((result.part[k] = EachElement(operation, a.part[k], kElements)), ...);
        return result;
    }
    template <class Operation, int... i>
    [[gnu::always_inline]] static Register EachElement(Operation operation, Register x,
                                                       std::integer_sequence<int, i...>) {
        return Register{operation(x[i])...};
    }
    template <class From, int... k>
    [[gnu::always_inline]] static Pack PermutedBy(const Pack &a, From from,
                                                  std::integer_sequence<int, k...>) {
        Pack b;
        ((b.part[k] = PermutedRegister<k>(a, from, kElements)), ...);
        return b;
    }
    template <int k, class From, int... i>
    [[gnu::always_inline]] static Register PermutedRegister(const Pack &a, From from,
                                                            std::integer_sequence<int, i...>) {
        constexpr int source = from(k * kWidth) / kWidth;
        return __builtin_shufflevector(a.part[source], a.part[source],
                                       (from(k * kWidth + i) % kWidth)...);
    }
    template <int... k>
    [[gnu::always_inline]] static Pack<T, 2 * n, bytes> DoubledBy(
        const Pack &a, std::integer_sequence<int, k...>) {
        Pack<T, 2 * n, bytes> b;
        ((b.part[k] = a.part[k % kRegisters]), ...);
        return b;
    }
    template <int... k>
    [[gnu::always_inline]] static Pack<T, n / 2, bytes> FoldedBy(const Pack &a,
                                                                 std::integer_sequence<int, k...>) {
        Pack<T, n / 2, bytes> b;
        ((b.part[k] = a.part[k] + a.part[k + kRegisters / 2]), ...);
        return b;
    }
    template <int... i>
    [[gnu::always_inline]] static auto TwiceARegister(Register a,
                                                      std::integer_sequence<int, i...>) {
        return __builtin_shufflevector(a, a, i..., i...);
    }
    template <int... i>
    [[gnu::always_inline]] static auto FoldedRegister(Register a,
                                                      std::integer_sequence<int, i...>) {
        return __builtin_shufflevector(a, a, i...) + __builtin_shufflevector(a, a, (i + n / 2)...);
    }
};

template <class V>
struct ScalarOfPack {
    using Type = V;
};
template <std::floating_point T, int n, int bytes>
struct ScalarOfPack<Pack<T, n, bytes>> {
    using Type = T;
};
template <class V>
using ScalarOf = typename ScalarOfPack<V>::Type;

/// Of the values at N wavelengths.
template <class V, std::size_t N>
V Sum(const std::array<V, N> &values) {
    V sum = values[0];
    for (std::size_t k = 1; k < N; ++k)
        sum = sum + values[k];
    return sum;
}

}  // namespace pbrt::feather
