// Every operation, type and size against the loop over its elements.

#include "pbrt/simd/simd.h"

#include <gtest/gtest.h>

#include "pbrt/simd/math.h"
#include "simd/any.h"

namespace pbrt {
namespace {

constexpr int kRounds = 300;

template <class V>
class EverySimd : public testing::Test {
  protected:
    using T = typename V::Scalar;
    std::mt19937 random{1};

    /// wide(a, b)[k] is one(a[k], b[k]).
    template <class Wide, class One>
    void Expect(const char *name, const Wide &wide, const One &one) {
        for (int round = 0; round < kRounds; ++round) {
            const V a = AnyVector<V>(random), b = AnyVector<V>(random);
            const V all = wide(a, b);
            for (int k = 0; k < V::kSize; ++k)
                ASSERT_TRUE(Same(all[k], T(one(a[k], b[k]))))
                    << name << " of " << a[k] << " and " << b[k] << ": " << all[k];
        }
    }
    template <class Operation>
    void Expect(const char *name, const Operation &operation) {
        Expect(name, operation, operation);
    }
    /// The bits of wide(a, b) and its elements are one(a[k], b[k]).
    template <class Operation>
    void ExpectMask(const char *name, const Operation &operation) {
        for (int round = 0; round < kRounds; ++round) {
            const V a = AnyVector<V>(random), b = round % 3 ? AnyVector<V>(random) : a;
            const auto mask = operation(a, b);
            const LaneBits bits = BitsOf(mask);
            for (int k = 0; k < V::kSize; ++k) {
                ASSERT_EQ(bool(bits >> k & 1), bool(operation(a[k], b[k])))
                    << name << " of " << a[k] << " and " << b[k];
                ASSERT_EQ(mask[k], bool(operation(a[k], b[k])));
            }
        }
    }
};
template <class V>
class EveryFloatSimd : public EverySimd<V> {};
template <class V>
class EveryIntSimd : public EverySimd<V> {};

using Floats = testing::Types<FloatX4, Simd<float, 8>, FloatX16, Simd<double, 2>, DoubleX4,
                              DoubleX8, DoubleX16>;
using Ints =
    testing::Types<IntX4, Simd<int32_t, 8>, IntX16, Simd<uint32_t, 4>, Simd<uint32_t, 8>, UintX16,
                   Simd<uint64_t, 2>, Simd<uint64_t, 4>, Simd<uint64_t, 8>, Uint64X16>;
using Everything =
    testing::Types<FloatX4, Simd<float, 8>, FloatX16, Simd<double, 2>, DoubleX4, DoubleX8,
                   DoubleX16, IntX4, Simd<int32_t, 8>, IntX16, Simd<uint32_t, 4>, Simd<uint32_t, 8>,
                   UintX16, Simd<uint64_t, 2>, Simd<uint64_t, 4>, Simd<uint64_t, 8>, Uint64X16>;
TYPED_TEST_SUITE(EverySimd, Everything);
TYPED_TEST_SUITE(EveryFloatSimd, Floats);
TYPED_TEST_SUITE(EveryIntSimd, Ints);

/// x, or for numbers with a sign x / 2^16: sums and products of two overflow then nowhere.
template <class X>
X WithoutOverflow(X x) {
    return x;
}
int32_t WithoutOverflow(int32_t x) {
    return x >> 16;
}
template <int N>
Simd<int32_t, N> WithoutOverflow(Simd<int32_t, N> x) {
    return x >> 16;
}

TYPED_TEST(EverySimd, Arithmetic) {
    const auto with = [](auto operation) {
        return [operation](auto a, auto b) {
            return operation(WithoutOverflow(a), WithoutOverflow(b));
        };
    };
    this->Expect("+", with([](auto a, auto b) { return a + b; }));
    this->Expect("-", with([](auto a, auto b) { return a - b; }));
    this->Expect("*", with([](auto a, auto b) { return a * b; }));
    this->Expect("+=", with([](auto a, auto b) { return a += b; }));
    this->Expect("-=", with([](auto a, auto b) { return a -= b; }));
    this->Expect("*=", with([](auto a, auto b) { return a *= b; }));
}
TYPED_TEST(EveryFloatSimd, Division) {
    this->Expect("/", [](auto a, auto b) { return a / b; });
    this->Expect("/=", [](auto a, auto b) { return a /= b; });
    this->Expect("unary -", [](auto a, auto) { return -a; });
}
TYPED_TEST(EveryIntSimd, Bits) {
    this->Expect("&", [](auto a, auto b) { return a & b; });
    this->Expect("|", [](auto a, auto b) { return a | b; });
    this->Expect("^", [](auto a, auto b) { return a ^ b; });
    this->Expect("~", [](auto a, auto) { return ~a; });
    this->Expect("&=", [](auto a, auto b) { return a &= b; });
    this->Expect("|=", [](auto a, auto b) { return a |= b; });
    this->Expect("^=", [](auto a, auto b) { return a ^= b; });
    for (const int n : {0, 1, 7, 31}) {
        this->Expect("<<", [n](auto a, auto) { return a << n; });
        this->Expect(">>", [n](auto a, auto) { return a >> n; });
    }
}
TYPED_TEST(EverySimd, Comparisons) {
    this->ExpectMask("<", [](auto a, auto b) { return a < b; });
    this->ExpectMask(">", [](auto a, auto b) { return a > b; });
    this->ExpectMask("<=", [](auto a, auto b) { return a <= b; });
    this->ExpectMask(">=", [](auto a, auto b) { return a >= b; });
    this->ExpectMask("==", [](auto a, auto b) { return a == b; });
    this->ExpectMask("!=", [](auto a, auto b) { return a != b; });
}
TYPED_TEST(EverySimd, Selection) {
    this->Expect("Min", [](auto a, auto b) { return Min(a, b); });
    this->Expect("Max", [](auto a, auto b) { return Max(a, b); });
    this->Expect("Select", [](auto a, auto b) { return Select(a < b, a, b); });
}
TYPED_TEST(EverySimd, Scalars) {
    using T = typename TypeParam::Scalar;
    for (int round = 0; round < kRounds; ++round) {
        const T x = AnyNumber<T>(this->random);
        const TypeParam all = x, mixed = AnyVector<TypeParam>(this->random);
        const auto mask = mixed < x;
        const TypeParam chosen = Select(mask, T(1), T(2)), either = Select(mask, x, mixed);
        for (int k = 0; k < TypeParam::kSize; ++k) {
            ASSERT_TRUE(Same(all[k], x));
            ASSERT_TRUE(Same(chosen[k], mixed[k] < x ? T(1) : T(2)));
            ASSERT_TRUE(Same(either[k], mixed[k] < x ? x : mixed[k]));
        }
    }
}
TYPED_TEST(EverySimd, MemoryAndElements) {
    using T = typename TypeParam::Scalar;
    constexpr int n = TypeParam::kSize;
    T from[n + 1], to[n + 1];
    for (int k = 0; k <= n; ++k)
        from[k] = AnyNumber<T>(this->random);
    TypeParam::Load(from + 1).Store(to + 1);  // aligned to an element only
    const TypeParam numbered = TypeParam::Generate([](int k) { return 3 * k + 1; });
    for (int k = 0; k < n; ++k) {
        ASSERT_TRUE(Same(to[k + 1], from[k + 1]));
        ASSERT_EQ(numbered[k], T(3 * k + 1));
    }
    for (int k = 0; k < TypeParam::kSize; ++k)
        ASSERT_EQ(TypeParam{}[k], T(0));
}
TYPED_TEST(EveryFloatSimd, Functions) {
    this->Expect("Abs", [](auto a, auto) { return Abs(a); });
    this->Expect("CopySign", [](auto a, auto b) { return CopySign(a, b); });
    this->Expect("MulSign", [](auto a, auto b) { return MulSign(a, b); });
    this->Expect("SignOf", [](auto a, auto) { return SignOf(a); });
    this->Expect("Sqrt", [](auto a, auto) { return Sqrt(a); });
    this->Expect("SafeSqrt", [](auto a, auto) { return SafeSqrt(a); });
    this->Expect("Round", [](auto a, auto) { return Round(a); });
    this->Expect("Floor", [](auto a, auto) { return Floor(a); });
    this->Expect("Clamp", [](auto a, auto) { return Clamp(a, -1, 2); });
    this->Expect(
        "MapElements", [](auto a, auto) { return MapElements([](auto e) { return e + 1; }, a); },
        [](auto a, auto) { return a + 1; });
}

TEST(Simd, MinAndMaxAtTheirEdges) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expect = [](auto a, auto b, float min, float max) {
        EXPECT_TRUE(Same(Min(a, b), min) && Same(Max(a, b), max)) << a << " " << b;
        const auto wide = [](float x) { return FloatX4(x); };
        EXPECT_TRUE(Same(Min(wide(a), wide(b))[2], min) && Same(Max(wide(a), wide(b))[2], max));
    };
    expect(nan, 1.f, 1.f, 1.f);
    expect(1.f, nan, nan, nan);
    expect(0.f, -0.f, -0.f, -0.f);
    expect(-0.f, 0.f, 0.f, 0.f);
}

TEST(Simd, SelectCopiesBits) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const FloatX4 a(nan, -0.f, 1, nan), b(2, 0.f, nan, -0.f);
    const FloatX4 chosen = Select(SimdMask<4, 4>::FromBits(0b0011), a, b);
    EXPECT_TRUE(Same(chosen[0], nan) && Same(chosen[1], -0.f));
    EXPECT_TRUE(Same(chosen[2], nan) && Same(chosen[3], -0.f));
}

}  // namespace
}  // namespace pbrt
