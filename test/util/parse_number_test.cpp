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

}  // namespace
}  // namespace pbrt
