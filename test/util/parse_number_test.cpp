#include "pbrt/util/parse_number.h"

#include <gtest/gtest.h>

namespace pbrt {
namespace {

TEST(ParseNumber, TakesTheWholeText) {
    const std::pair<const char *, double> numbers[] = {
        {"1e3", 1e3}, {"-.5", -0.5}, {"+2", 2}, {"007", 7}, {"1E-2", 0.01}};
    for (const auto &[text, value] : numbers)
        EXPECT_EQ(ParseNumber(text), value) << text;
    for (const char *text : {"", "+", "-", "1,5", "1 ", " 1", "nan", "inf", "-inf", "1e999", "+-1",
                             "++1", "0x10", "1e", "abc"})
        EXPECT_EQ(ParseNumber(text), std::nullopt) << text;
}

TEST(ParseWhole, TakesWhatFromCharsTakesAndNoMore) {
    EXPECT_EQ(ParseWhole<int>("-12"), -12);
    EXPECT_EQ(ParseWhole<float>("1e-3"), 1e-3f);
    EXPECT_TRUE(std::isnan(ParseWhole<double>("nan").value()));
    for (const char *text : {"", "+1", " 1", "1 ", "1.", "2147483648", "0x1"})
        EXPECT_EQ(ParseWhole<int>(text), std::nullopt) << text;
}

}  // namespace
}  // namespace pbrt
