#include "pbrt/util/unpacked.h"

#include <gtest/gtest.h>

namespace pbrt {
namespace {

TEST(Unpacked, LimitsBySizeAndRatio) {
    constexpr uint64_t kFree = 64 << 20;
    EXPECT_EQ(MostUnpacked(0), kFree);
    EXPECT_EQ(MostUnpacked(10'000'000), 2'000'000'000u);
    EXPECT_EQ(WhyUnpackedTooLarge(kFree, 1), std::nullopt);
    EXPECT_EQ(WhyUnpackedTooLarge(kFree + 1, 1),
              "unpacks to more than 67 MB and 200 times its size (1 bytes), which is refused");
    EXPECT_EQ(WhyUnpackedTooLarge(1'000'000'000, 5'000'000), std::nullopt);
    EXPECT_NE(WhyUnpackedTooLarge(1'000'000'001, 5'000'000), std::nullopt);
}

}  // namespace
}  // namespace pbrt
