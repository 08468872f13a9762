#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace pbrt::feather {

// Not AVX-512's 64 bytes: those lower the clock of all that runs beside them, and TRT with 8 points
// takes a fifth longer.
#if defined(__AVX__)
inline constexpr int kRegisterBytes = 32;
#else
inline constexpr int kRegisterBytes = 16;
#endif

/// n scalars (a power of two; 16 bytes at least) in as many vector registers as they need.
/// Operators and functions go element by element; a scalar counts as n equal ones.
///
/// Not one wide vector type, which g++ takes apart into scalars where it exceeds the machine's
/// registers. All is inlined by force: in a large translation unit compilers would stop, and packs
/// would pass through memory.
template <std::floating_point T, int n>
struct Pack {
    static constexpr int kSize = n;
    static constexpr int kWidth = std::min(n, kRegisterBytes / int(sizeof(T)));
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
    /// True for the first n / 2 elements.
    [[gnu::always_inline]] static Mask FirstHalf() {
        T index[n];
        for (int k = 0; k < n; ++k)
            index[k] = T(k);
        return At(index) < Pack(T(n / 2));
    }
    [[gnu::always_inline]] T operator[](int k) const { return part[k / kWidth][k % kWidth]; }

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

    /// m ? a : b
    [[gnu::always_inline]] friend Pack Select(const Mask &m, const Pack &a, const Pack &b) {
        return Each<Pack>([](auto first, auto x, auto y) { return first ? x : y; }, m, a, b);
    }
    [[gnu::always_inline]] friend Pack Max(const Pack &a, const Pack &b) {
        return Select(a > b, a, b);
    }
    [[gnu::always_inline]] friend Pack Abs(const Pack &a) {
        return Each<Pack>(
            [](auto x) { return Register(IntRegister(x) & ~IntRegister(-Register{})); }, a);
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
        return Each<Pack>(
            [](auto x) { return EachElement([](T e) { return std::sqrt(e); }, x, kElements); }, a);
    }
    [[gnu::always_inline]] friend Pack Rint(const Pack &a) {
        return Each<Pack>(
            [](auto x) { return EachElement([](T e) { return std::rint(e); }, x, kElements); }, a);
    }
    [[gnu::always_inline]] friend Pack Sin(const Pack &a) {
        return Each<Pack>(
            [](auto x) { return EachElement([](T e) { return std::sin(e); }, x, kElements); }, a);
    }

    /// Element k of the result is element from(k) of a. What goes into one register comes from one
    /// register; `from` is a constexpr lambda without captures.
    template <class From>
    [[gnu::always_inline]] friend Pack Permuted(const Pack &a, From from) {
        return PermutedBy(a, from, kIndices);
    }
    /// a, and a again.
    [[gnu::always_inline]] friend Pack<T, 2 * n> Doubled(const Pack &a) {
        using Twice = Pack<T, 2 * n>;
        if constexpr (Twice::kWidth > kWidth)
            return {TwiceARegister(a.part[0], kElements)};
        else
            return DoubledBy(a, Twice::kIndices);
    }
    /// The first half plus the second.
    [[gnu::always_inline]] friend Pack<T, n / 2> Folded(const Pack &a) {
        using Half = Pack<T, n / 2>;
        if constexpr (kRegisters > 1)
            return FoldedBy(a, Half::kIndices);
        else
            return {FoldedRegister(a.part[0], Half::kElements)};
    }

    static constexpr std::make_integer_sequence<int, kRegisters> kIndices{};
    static constexpr std::make_integer_sequence<int, kWidth> kElements{};

    template <class... Registers>
    requires(sizeof...(Registers) == kRegisters && (std::is_same_v<Registers, Register> && ...))
        [[gnu::always_inline]] Pack(Registers... parts)
        : part{parts...} {}

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
    [[gnu::always_inline]] static Pack<T, 2 * n> DoubledBy(const Pack &a,
                                                           std::integer_sequence<int, k...>) {
        Pack<T, 2 * n> b;
        ((b.part[k] = a.part[k % kRegisters]), ...);
        return b;
    }
    template <int... k>
    [[gnu::always_inline]] static Pack<T, n / 2> FoldedBy(const Pack &a,
                                                          std::integer_sequence<int, k...>) {
        Pack<T, n / 2> b;
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

/// What packs do element by element, for one scalar.
template <std::floating_point T>
T Select(bool first, T a, T b) {
    return first ? a : b;
}
template <std::floating_point T>
T Max(T a, T b) {
    return std::max(a, b);
}
template <std::floating_point T>
T Abs(T x) {
    return std::abs(x);
}
template <std::floating_point T>
T SignOf(T x) {
    return std::copysign(T(1), x);
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

template <class V>
struct ScalarOfPack {
    using Type = V;
};
template <std::floating_point T, int n>
struct ScalarOfPack<Pack<T, n>> {
    using Type = T;
};
template <class V>
using ScalarOf = typename ScalarOfPack<V>::Type;

/// The elements of `a`, as often as m elements need.
template <int m, std::floating_point T, int n>
[[gnu::always_inline]] inline Pack<T, m> Repeated(const Pack<T, n> &a) {
    if constexpr (m == n)
        return a;
    else
        return Repeated<m>(Doubled(a));
}

/// The halves of a pack in each other's place; either half in both places.
template <class Pack>
[[gnu::always_inline]] inline Pack HalvesSwapped(const Pack &a) {
    return Permuted(a, [](int k) { return (k + Pack::kSize / 2) % Pack::kSize; });
}
template <class Pack>
[[gnu::always_inline]] inline Pack FirstHalfTwice(const Pack &a) {
    return Permuted(a, [](int k) { return k % (Pack::kSize / 2); });
}
template <class Pack>
[[gnu::always_inline]] inline Pack SecondHalfTwice(const Pack &a) {
    return Permuted(a, [](int k) { return Pack::kSize / 2 + k % (Pack::kSize / 2); });
}
/// a in the first half, b in the second.
template <class Pack>
[[gnu::always_inline]] inline Pack Halves(ScalarOf<Pack> a, ScalarOf<Pack> b) {
    return Select(Pack::FirstHalf(), Pack(a), Pack(b));
}

/// The sum of the elements, in a fixed order.
template <std::floating_point T, int n>
[[gnu::always_inline]] inline T Sum(const Pack<T, n> &a) {
    if constexpr (n == 2)
        return a[0] + a[1];
    else if constexpr (n * sizeof(T) == 16)
        return (a[0] + a[2]) + (a[1] + a[3]);
    else
        return Sum(Folded(a));
}

/// Of the values at N wavelengths.
template <std::floating_point T, std::size_t N>
T Sum(const std::array<T, N> &values) {
    T sum = values[0];
    for (std::size_t k = 1; k < N; ++k)
        sum += values[k];
    return sum;
}

}  // namespace pbrt::feather
