#include "pbrt/simd/mask.h"

#include <gtest/gtest.h>

#include <vector>

#include "pbrt/simd/convert.h"

namespace pbrt {
namespace {

template <class Mask>
class EveryMask : public testing::Test {
  protected:
    static constexpr int n = Mask::kSize;
    static constexpr LaneBits kAll = LaneBits((uint64_t(1) << n) - 1);
    /// All masks of few elements; of sixteen those with steps of a prime.
    template <class F>
    static void ForEach(F f) {
        for (LaneBits bits = 0; bits <= kAll; bits += n < 16 ? 1 : 257)
            f(bits);
        f(kAll);
    }
};
using Masks = testing::Types<SimdMask<4, 4>, SimdMask<4, 8>, SimdMask<4, 16>, SimdMask<8, 2>,
                             SimdMask<8, 4>, SimdMask<8, 8>, SimdMask<8, 16>>;
TYPED_TEST_SUITE(EveryMask, Masks);

TYPED_TEST(EveryMask, BitsThereAndBack) {
    this->ForEach([&](LaneBits bits) {
        const TypeParam mask = TypeParam::FromBits(bits);
        ASSERT_EQ(BitsOf(mask), bits);
        ASSERT_EQ(Any(mask), bits != 0);
        ASSERT_EQ(All(mask), bits == this->kAll);
        ASSERT_EQ(BitsOf(!mask), ~bits & this->kAll);
        if constexpr (TypeParam::kSize >= 4) {  // no vector is shorter than 16 bytes
            ASSERT_EQ(BitsOf(ConvertMask<4>(mask)), bits);
        }
        ASSERT_EQ(BitsOf(ConvertMask<8>(mask)), bits);
        typename TypeParam::Integer stored[TypeParam::kSize];
        mask.Store(stored);
        for (int k = 0; k < TypeParam::kSize; ++k) {
            ASSERT_EQ(mask[k], bool(bits >> k & 1));
            ASSERT_EQ(stored[k], -int(bits >> k & 1));
        }
    });
    EXPECT_EQ(BitsOf(TypeParam(true)), this->kAll);
    EXPECT_EQ(BitsOf(TypeParam(false)), 0u);
}

TYPED_TEST(EveryMask, Logic) {
    this->ForEach([&](LaneBits a) {
        const LaneBits b = (a * 7 + 5) & this->kAll;
        const TypeParam x = TypeParam::FromBits(a), y = TypeParam::FromBits(b);
        ASSERT_EQ(BitsOf(x & y), a & b);
        ASSERT_EQ(BitsOf(x | y), a | b);
        ASSERT_EQ(BitsOf(x != y), a ^ b);
        ASSERT_EQ(BitsOf(x == y), ~(a ^ b) & this->kAll);
        TypeParam z = x;
        ASSERT_EQ(BitsOf(z &= y), a & b);
        ASSERT_EQ(BitsOf(z |= x), a);
    });
}

TEST(Mask, Lanes) {
    EXPECT_EQ(FirstLanes(0), 0u);
    EXPECT_EQ(FirstLanes(3), 7u);
    EXPECT_EQ(FirstLanes(16), 0xffffu);
    EXPECT_EQ(FirstLanes(100), 0xffffu);
    std::vector<int> seen;
    ForEachLane(0b1010010u, [&](int k) { seen.push_back(k); });
    EXPECT_EQ(seen, (std::vector{1, 4, 6}));
}

}  // namespace
}  // namespace pbrt
