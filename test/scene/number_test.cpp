#include "pbrt/scene/number.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace pbrt {
namespace {

TEST(Number, ReadsDecimalsAndExponents) {
    EXPECT_EQ(ParseFloat("0"), 0.f);
    EXPECT_EQ(ParseFloat("-1.5"), -1.5f);
    EXPECT_EQ(ParseFloat("+2"), 2.f);
    EXPECT_EQ(ParseFloat(".25"), .25f);
    EXPECT_EQ(ParseFloat("-.5"), -.5f);
    EXPECT_EQ(ParseFloat("3."), 3.f);
    EXPECT_EQ(ParseFloat("1e3"), 1000.f);
    EXPECT_EQ(ParseFloat("1E-3"), 1e-3f);
    EXPECT_EQ(ParseFloat("1e+3"), 1000.f);
    EXPECT_EQ(ParseFloat("16777217"), 16777216.f);
    EXPECT_EQ(ParseFloat("0.1"), 0.1f);
}

TEST(Number, MinusZeroKeepsItsSign) {
    EXPECT_TRUE(std::signbit(*ParseFloat("-0")));
}

TEST(Number, ReadsHexadecimalFloats) {
    EXPECT_EQ(ParseFloat("0x1p-3"), 0.125f);
    EXPECT_EQ(ParseFloat("-0x1.8p1"), -3.f);
    EXPECT_EQ(ParseFloat("0X10"), 16.f);
}

TEST(Number, RefusesWhatIsNoFiniteNumber) {
    for (const char *text :
         {"",      "-",    "+",    ".",        "e5",  "1e",   "1x",   "1.2.3", "1,5",
          "inf",   "-inf", "+inf", "infinity", "nan", "-nan", "+nan", "NaN",   "0x",
          "0xinf", "0x-1", "--1",  "+-1",      "-+1", " 1",   "1 "})
        EXPECT_FALSE(ParseFloat(text)) << '"' << text << '"';
}

TEST(Number, TooLargeIsRefusedAndTooSmallIsZero) {
    EXPECT_EQ(ParseFloat("3.4028235e38"), std::numeric_limits<float>::max());
    EXPECT_FALSE(ParseFloat("3.5e38"));
    EXPECT_FALSE(ParseFloat("-1e39"));
    EXPECT_FALSE(ParseFloat("1e999"));
    EXPECT_FALSE(ParseFloat("0x1p128"));
    EXPECT_EQ(ParseFloat("1e-60"), 0.f);
    EXPECT_EQ(ParseFloat("1e-999"), 0.f);
    EXPECT_EQ(ParseFloat("0x1p-2000"), 0.f);
    EXPECT_EQ(ParseFloat("1e-45"), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(WhyNotFloat("1e39"), "\"1e39\" is too large for a 32-bit float");
    EXPECT_EQ(WhyNotFloat("nan"), "\"nan\" is not a number");
}

/// Decimals as printf writes them, on both sides of what is short.
TEST(Number, RoundsAsTheStandardLibraryDoes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-12, 12), mantissa(-10, 10);
    for (int i = 0; i < 200000; ++i) {
        const double x = mantissa(random) * std::pow(10., exponent(random));
        const std::string text =
            fmt::format(fmt::runtime(i % 2 ? "{:.{}g}" : "{:.{}f}"), x, 1 + i % 11);
        float expected = 0;
        std::from_chars(text.data(), text.data() + text.size(), expected);
        const std::optional<float> value = ParseFloat(text);
        ASSERT_TRUE(value) << text;
        ASSERT_EQ(std::bit_cast<uint32_t>(*value), std::bit_cast<uint32_t>(expected)) << text;
    }
}

TEST(Number, ShortDecimalsEndWhereTheyEnd) {
    const auto rest = [](std::string_view text) {
        float value = 0;
        const char *const stop = ParseShortDecimal(text.data(), text.data() + text.size(), &value);
        return stop ? std::string(stop, text.data() + text.size()) : "none";
    };
    EXPECT_EQ(rest("1.5 2"), " 2");
    EXPECT_EQ(rest("-.5]"), "]");
    EXPECT_EQ(rest("1.x"), "x");
    EXPECT_EQ(rest("16777215"), "");
    for (const char *text : {"", "-", ".", "-.", "+1", "16777216", "0.00000000001", "x", "inf",
                             "00000000000000000001"})
        EXPECT_EQ(rest(text), "none") << text;
}

TEST(Number, ReadsIntegers) {
    EXPECT_EQ(ParseInt("12"), 12);
    EXPECT_EQ(ParseInt("-12"), -12);
    EXPECT_EQ(ParseInt("+12"), 12);
    EXPECT_EQ(ParseInt("2147483647"), 2147483647);
    EXPECT_EQ(ParseInt("-2147483648"), -2147483647 - 1);
}

TEST(Number, RefusesWhatIsNoInteger) {
    for (const char *text : {"", "-", "1.0", "1e3", "0x10", "1a", "+-1", "--1", "2147483648"})
        EXPECT_FALSE(ParseInt(text)) << '"' << text << '"';
    EXPECT_EQ(WhyNotInt("2147483648"), "\"2147483648\" is too large for a 32-bit integer");
    EXPECT_EQ(WhyNotInt("1.5"), "\"1.5\" is not an integer");
    EXPECT_EQ(WhyNotInt("-"), "\"-\" is not an integer");
}

}  // namespace
}  // namespace pbrt
