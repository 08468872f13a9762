#include "pbrt/util/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>

#include "support/sanitized.h"

namespace pbrt {
namespace {

TEST(Memory, BytesAsText) {
    EXPECT_EQ(ByteText(0), "0 bytes");
    EXPECT_EQ(ByteText(999), "999 bytes");
    EXPECT_EQ(ByteText(1000), "1.0 KB");
    EXPECT_EQ(ByteText(9'949'999), "9.9 MB");
    EXPECT_EQ(ByteText(9'960'000), "10 MB");
    EXPECT_EQ(ByteText(999'499'999), "999 MB");
    EXPECT_EQ(ByteText(999'600'000), "1.0 GB");
    EXPECT_EQ(ByteText(57'000'000'000), "57 GB");
    EXPECT_EQ(ByteText(~uint64_t(0)), "18 EB");
}

TEST(Memory, BytesFromText) {
    EXPECT_EQ(ParseBytes("200000"), 200'000u);
    EXPECT_EQ(ParseBytes("4G"), 4'000'000'000u);
    EXPECT_EQ(ParseBytes("1.5 gb"), 1'500'000'000u);
    EXPECT_EQ(ParseBytes("2TB"), 2'000'000'000'000u);
    for (const char *text : {"", "G", "-1", "nan", "inf", "4X", "4GG", "1e300", "20E"})
        EXPECT_FALSE(ParseBytes(text)) << text;
}

TEST(Memory, MoreThanTheMachineHasIsTooLarge) {
    EXPECT_GT(AvailableMemory(), 1'000'000u);
    EXPECT_FALSE(WhyTooLarge(1000));
    const auto why = WhyTooLarge(uint64_t(1) << 62);
    ASSERT_TRUE(why);
    EXPECT_EQ(why->find("needs 4.6 EB of memory, "), 0u) << *why;
}

/// In a child, for a limit cannot be raised again.
TEST(Memory, ItsOwnLimitCounts) {
    if (kSanitized) GTEST_SKIP() << "sanitizers take more than any limit";
    const auto limited = [] {
        const uint64_t kLimit = 1'000'000'000;
        if (LimitMemory(kLimit)) std::exit(1);
        if (AvailableMemory() > kLimit || !WhyTooLarge(kLimit) || WhyTooLarge(kLimit / 2))
            std::exit(2);
        std::exit(0);
    };
    EXPECT_EXIT(limited(), testing::ExitedWithCode(0), "");
    const auto addresses = [] {
        rlimit limit{2'000'000'000, 2'000'000'000};
        if (setrlimit(RLIMIT_AS, &limit) != 0) std::exit(1);
        std::exit(AvailableMemory() < limit.rlim_cur ? 0 : 2);
    };
    EXPECT_EXIT(addresses(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace pbrt
