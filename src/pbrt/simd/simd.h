#pragma once

#include <concepts>
#include <cstring>

#include "mask.h"

namespace pbrt {

/// N numbers side by side (a power of two; at least 16 bytes): float, double, int32_t, uint32_t,
/// uint64_t or int64_t. Operators and functions go element by element, and a scalar counts as N
/// equal ones; what overflows is undefined where it is for one. Functions that have the same name
/// for scalars (math.h) let a formula be written once for a type V, which is T or Simd<T, N>.
/// Differences between compilers are told in registers.h.
template <class T, int N>
class Simd {
  public:
    using Scalar = T;
    using Mask = SimdMask<int(sizeof(T)), N>;
    static constexpr int kSize = N, kWidth = registers::Width(int(sizeof(T)), N),
                         kRegisters = N / kWidth;
    static_assert(std::has_single_bit(unsigned(N)) && N * sizeof(T) >= 16);
    typedef T Register __attribute__((vector_size(kWidth * sizeof(T))));
    using Bits = typename Mask::Register;  ///< a register's bits as integers with a sign

    Register part[kRegisters];

    Simd() = default;
    /// All elements x.
    [[gnu::always_inline]] Simd(T x) {
        *this = registers::Each<Simd>([x](auto zero) { return x - zero; }, Simd{});
    }
    /// The N elements in order.
    template <std::convertible_to<T>... Ts>
    requires(sizeof...(Ts) + 2 == N)
        [[gnu::always_inline]] constexpr Simd(T first, T second, Ts... others) {
        const T elements[N] = {first, second, T(others)...};
        *this = Generate([&](int k) { return elements[k]; });
    }
    /// Element k is f(k), k known when compiling.
    template <class F>
    [[gnu::always_inline]] static constexpr Simd Generate(const F &f) {
        return GenerateParts(f, std::make_integer_sequence<int, kRegisters>());
    }
    /// The N numbers there; any alignment.
    [[gnu::always_inline]] static Simd Load(const T *from) {
        Simd a;
        std::memcpy(a.part, from, sizeof a.part);
        return a;
    }
    [[gnu::always_inline]] void Store(T *to) const { std::memcpy(to, part, sizeof part); }

    [[gnu::always_inline]] T operator[](int k) const {
        return part[unsigned(k) / kWidth][unsigned(k) % kWidth];
    }
    [[gnu::always_inline]] void Set(int k, T x) {
        part[unsigned(k) / kWidth][unsigned(k) % kWidth] = x;
    }

    [[gnu::always_inline]] friend Simd operator+(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x + y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator-(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x - y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator*(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x * y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator/(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x / y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator-(const Simd &a) {
        return registers::Each<Simd>([](auto x) { return -x; }, a);
    }
    [[gnu::always_inline]] friend Simd operator&(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x & y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator|(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x | y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator^(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return x ^ y; }, a, b);
    }
    [[gnu::always_inline]] friend Simd operator~(const Simd &a) {
        return registers::Each<Simd>([](auto x) { return ~x; }, a);
    }
    [[gnu::always_inline]] friend Simd operator<<(const Simd &a, int n) {
        return registers::Each<Simd>([n](auto x) { return x << n; }, a);
    }
    [[gnu::always_inline]] friend Simd operator>>(const Simd &a, int n) {
        return registers::Each<Simd>([n](auto x) { return x >> n; }, a);
    }
    [[gnu::always_inline]] Simd &operator+=(const Simd &b) { return *this = *this + b; }
    [[gnu::always_inline]] Simd &operator-=(const Simd &b) { return *this = *this - b; }
    [[gnu::always_inline]] Simd &operator*=(const Simd &b) { return *this = *this * b; }
    [[gnu::always_inline]] Simd &operator/=(const Simd &b) { return *this = *this / b; }
    [[gnu::always_inline]] Simd &operator&=(const Simd &b) { return *this = *this & b; }
    [[gnu::always_inline]] Simd &operator|=(const Simd &b) { return *this = *this | b; }
    [[gnu::always_inline]] Simd &operator^=(const Simd &b) { return *this = *this ^ b; }

    [[gnu::always_inline]] friend Mask operator<(const Simd &a, const Simd &b) {
        return registers::Each<Mask>([](auto x, auto y) { return x < y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator>(const Simd &a, const Simd &b) {
        return registers::Each<Mask>([](auto x, auto y) { return x > y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator<=(const Simd &a, const Simd &b) {
        return registers::Each<Mask>([](auto x, auto y) { return x <= y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator>=(const Simd &a, const Simd &b) {
        return registers::Each<Mask>([](auto x, auto y) { return x >= y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator==(const Simd &a, const Simd &b) {
        return registers::Each<Mask>([](auto x, auto y) { return x == y; }, a, b);
    }
    [[gnu::always_inline]] friend Mask operator!=(const Simd &a, const Simd &b) {
        return registers::Each<Mask>([](auto x, auto y) { return x != y; }, a, b);
    }

    /// a where the mask holds, else b: bits are copied, NaN too.
    [[gnu::always_inline]] friend Simd Select(const Mask &mask, const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto m, auto x, auto y) { return m ? x : y; }, mask, a, b);
    }
    /// a < b ? a : b, so b where one of them is NaN, or both are zeros of either sign.
    [[gnu::always_inline]] friend Simd Min(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return registers::Min(x, y); }, a, b);
    }
    /// a > b ? a : b, likewise.
    [[gnu::always_inline]] friend Simd Max(const Simd &a, const Simd &b) {
        return registers::Each<Simd>([](auto x, auto y) { return registers::Max(x, y); }, a, b);
    }

    // Of floating point numbers.

    /// |a|, also of -0 and NaN.
    [[gnu::always_inline]] friend Simd Abs(const Simd &a) {
        return registers::Each<Simd>([](auto x) { return Register(Bits(x) & ~SignBit()); }, a);
    }
    /// The size of a with the sign bit of b.
    [[gnu::always_inline]] friend Simd CopySign(const Simd &a, const Simd &b) {
        return registers::Each<Simd>(
            [](auto x, auto y) { return Register((Bits(x) & ~SignBit()) | (Bits(y) & SignBit())); },
            a, b);
    }
    /// a, or -a where b has the sign bit.
    [[gnu::always_inline]] friend Simd MulSign(const Simd &a, const Simd &b) {
        return registers::Each<Simd>(
            [](auto x, auto y) { return Register(Bits(x) ^ (Bits(y) & SignBit())); }, a, b);
    }
    /// Correctly rounded.
    [[gnu::always_inline]] friend Simd Sqrt(const Simd &a) {
        return registers::Each<Simd>([](auto x) { return registers::Sqrt(x); }, a);
    }
    /// To the nearest whole number, of two the even one.
    [[gnu::always_inline]] friend Simd Round(const Simd &a) {
        return registers::Each<Simd>([](auto x) { return registers::RoundBy<8>(x); }, a);
    }
    /// The largest whole number <= a.
    [[gnu::always_inline]] friend Simd Floor(const Simd &a) {
        return registers::Each<Simd>([](auto x) { return registers::RoundBy<9>(x); }, a);
    }
    /// f(element) for each, one by one.
    template <class F>
    [[gnu::always_inline]] friend Simd MapElements(const F &f, const Simd &a) {
        return registers::Each<Simd>([&](auto x) { return registers::Map(f, x); }, a);
    }

  private:
    [[gnu::always_inline]] static Bits SignBit() { return Bits(-Register{}); }

    template <class F, int... k>
    [[gnu::always_inline]] static constexpr Simd GenerateParts(const F &f,
                                                               std::integer_sequence<int, k...>) {
        Simd a{};
        ((a.part[k] = registers::Generate<Register>([&](int i) { return T(f(k * kWidth + i)); },
                                                    std::make_integer_sequence<int, kWidth>())),
         ...);
        return a;
    }
};

/// Width of packets of rays, surfaces and so on.
inline constexpr int kPacketSize = 16;
inline constexpr LaneBits kAllLanes = 0xffff;

template <class T>
using SimdX16 = Simd<T, 16>;
using FloatX16 = Simd<float, 16>;
using IntX16 = Simd<int32_t, 16>;
using UintX16 = Simd<uint32_t, 16>;
using DoubleX16 = Simd<double, 16>;
using Uint64X16 = Simd<uint64_t, 16>;
using MaskX16 = SimdMask<4, 16>;
using DoubleX8 = Simd<double, 8>;
using FloatX4 = Simd<float, 4>;
using IntX4 = Simd<int32_t, 4>;
using DoubleX4 = Simd<double, 4>;

/// The bits of sixteen as a mask.
[[gnu::always_inline]] inline MaskX16 MaskOf(LaneBits bits) {
    return MaskX16::FromBits(bits);
}
/// 0, 1, 2, ... 15.
inline constexpr UintX16 kLaneNumbers = UintX16::Generate([](int k) { return k; });

/// N times x.
template <int N, class T>
[[gnu::always_inline]] inline Simd<T, N> Broadcast(T x) {
    return x;
}
/// Select for two scalars.
template <int Bytes, int N, class T>
requires(std::is_arithmetic_v<T> && sizeof(T) == Bytes)
    [[gnu::always_inline]] inline Simd<T, N> Select(const SimdMask<Bytes, N> &mask, T a, T b) {
    return Select(mask, Simd<T, N>(a), Simd<T, N>(b));
}

template <class V>
struct SimdTraits {
    using Scalar = V;
    template <class U>
    using Of = U;
};
template <class T, int N>
struct SimdTraits<Simd<T, N>> {
    using Scalar = T;
    template <class U>
    using Of = Simd<U, N>;
};
/// Type of a V's numbers: V itself where it is a scalar.
template <class V>
using ScalarOf = typename SimdTraits<V>::Scalar;
/// As many int32_t as V has numbers.
template <class V>
using IntOf = typename SimdTraits<V>::template Of<int32_t>;
/// Result of comparing two V: bool, or one for each element.
template <class V>
using MaskFor = decltype(std::declval<V>() < std::declval<V>());
/// One float or several.
template <typename V>
concept AnyFloat = std::same_as < ScalarOf<V>,
float > ;

}  // namespace pbrt
