// Conversions, memory and permutations against loops.

#include "pbrt/simd/memory.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "pbrt/simd/math.h"
#include "pbrt/simd/permute.h"
#include "simd/any.h"

namespace pbrt {
namespace {

/// Numbers that every type holds.
template <class V>
V Small(std::mt19937 &random) {
    V v;
    for (int k = 0; k < V::kSize; ++k)
        v.Set(k, typename V::Scalar(random() % 1000));
    return v;
}
template <class U, class V>
void ExpectConverts(std::mt19937 &random) {
    const V v = Small<V>(random);
    const auto u = Convert<U>(v);
    const auto back = Convert<typename V::Scalar>(u);
    for (int k = 0; k < V::kSize; ++k) {
        ASSERT_EQ(u[k], U(v[k]));
        ASSERT_EQ(back[k], v[k]);
    }
}
template <int N>
void ExpectConversions() {
    std::mt19937 random(1);
    for (int round = 0; round < 100; ++round) {
        ExpectConverts<double, Simd<float, N>>(random);
        ExpectConverts<int32_t, Simd<float, N>>(random);
        ExpectConverts<int32_t, Simd<double, N>>(random);
        ExpectConverts<uint64_t, Simd<uint32_t, N>>(random);
        ExpectConverts<float, Simd<float, N>>(random);
    }
}
TEST(Convert, EverySize) {
    ExpectConversions<4>();
    ExpectConversions<8>();
    ExpectConversions<16>();
}
TEST(Convert, Halves) {
    std::mt19937 random(2);
    const UintX16 low = AnyVector<UintX16>(random), high = AnyVector<UintX16>(random);
    const Uint64X16 both = Join(low, high);
    for (int k = 0; k < 16; ++k) {
        EXPECT_EQ(both[k], uint64_t(high[k]) << 32 | low[k]);
        EXPECT_EQ(LowHalf(both)[k], low[k]);
        EXPECT_EQ(HighHalf(both)[k], high[k]);
    }
    for (const float x : {0.f, 0.9f, 1.f, 7.5f, 2147483520.f}) {
        EXPECT_EQ(Truncate(FloatX16(x))[3], Truncate(x));
        EXPECT_EQ(Truncate(x), uint32_t(x));
        EXPECT_EQ(ToFloat(UintX16(uint32_t(x)))[5], float(uint32_t(x)));
    }
}
TEST(Convert, Bits) {
    std::mt19937 random(3);
    const FloatX16 v = AnyVector<FloatX16>(random);
    const UintX16 bits = BitCast<uint32_t>(v);
    for (int k = 0; k < 16; ++k)
        EXPECT_EQ(bits[k], std::bit_cast<uint32_t>(v[k]));
}

template <class T>
void ExpectMemory() {
    std::mt19937 random(4);
    std::vector<T> table(100);
    for (T &t : table)
        t = AnyNumber<T>(random);
    for (int round = 0; round < 200; ++round) {
        UintX16 index;
        for (int k = 0; k < 16; ++k)
            index.Set(k, uint32_t(random() % table.size()));
        const LaneBits lanes = random() & kAllLanes;
        const SimdX16<T> v = Gather(table.data(), index), own = AnyVector<SimdX16<T>>(random);
        for (int k = 0; k < 16; ++k)
            ASSERT_TRUE(Same(v[k], table[index[k]]));
        std::vector<T> expected = table, packed(16 + 1, T(7)), expectedPacked;
        ForEachLane(lanes, [&](int k) {
            expected[index[k]] = own[k];
            expectedPacked.push_back(own[k]);
        });
        Scatter(table.data(), index, own, lanes);
        Compress(packed.data(), own, lanes);
        for (size_t k = 0; k < table.size(); ++k)
            ASSERT_TRUE(Same(table[k], expected[k]));
        for (size_t k = 0; k < expectedPacked.size(); ++k)
            ASSERT_TRUE(Same(packed[k], expectedPacked[k]));
        EXPECT_EQ(packed[16], T(7));
    }
}
TEST(Memory, GatherScatterCompress) {
    ExpectMemory<float>();
    ExpectMemory<uint32_t>();
}

template <class V>
class EveryPermutation : public testing::Test {};
using Vectors = testing::Types<FloatX4, Simd<float, 8>, FloatX16, Simd<double, 2>, DoubleX4,
                               DoubleX8, DoubleX16>;
TYPED_TEST_SUITE(EveryPermutation, Vectors);

TYPED_TEST(EveryPermutation, IsTheLoops) {
    using V = TypeParam;
    using T = typename V::Scalar;
    constexpr int n = V::kSize;
    std::mt19937 random(5);
    const V a = Small<V>(random);
    const V swapped = SwapHalves(a), low = DuplicateLow(a), high = DuplicateHigh(a),
            odd = Permute(a, [](int k) { return k ^ 1; }), halves = JoinHalves<V>(3, 4),
            sums = InclusiveScan(a);
    const auto twice = Doubled(a), four = Repeated<4 * n>(a);
    T sum = 0;
    for (int k = 0; k < n; ++k) {
        EXPECT_EQ(swapped[k], a[(k + n / 2) % n]);
        EXPECT_EQ(low[k], a[k % (n / 2)]);
        EXPECT_EQ(high[k], a[n / 2 + k % (n / 2)]);
        EXPECT_EQ(odd[k], a[k ^ 1]);
        EXPECT_EQ(halves[k], k < n / 2 ? 3 : 4);
        EXPECT_EQ(sums[k], sum += a[k]);
        for (int m = 0; m < 4; ++m) {
            EXPECT_EQ(twice[k + n * (m % 2)], a[k]);
            EXPECT_EQ(four[k + n * m], a[k]);
        }
    }
    EXPECT_EQ(Sum(a), sum);
    if constexpr (n * sizeof(T) >= 32) {
        const auto half = Folded(a);
        for (int k = 0; k < n / 2; ++k)
            EXPECT_EQ(half[k], a[k] + a[k + n / 2]);
    }
}
template <class T>
void ExpectPermutes() {
    std::mt19937 random(6);
    const auto a = Small<SimdX16<T>>(random);
    const IntX16 index = AnyVector<IntX16>(random);
    const auto b = Permute(a, index);
    int32_t numbers[16];
    std::iota(numbers, numbers + 16, 5);
    const IntX16 repeated = Repeat<4>(numbers);
    for (int k = 0; k < 16; ++k) {
        EXPECT_EQ(b[k], a[index[k] & 15]);
        EXPECT_EQ(repeated[k], 5 + k / 4);
    }
}
TEST(Permute, ByIndex) {
    ExpectPermutes<float>();
    ExpectPermutes<uint32_t>();
    ExpectPermutes<double>();
}

}  // namespace
}  // namespace pbrt
