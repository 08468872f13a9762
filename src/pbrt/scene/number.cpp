#include "pbrt/scene/number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "pbrt/util/parse_number.h"

namespace pbrt {
namespace {

bool IsDigit(char c) {
    return c >= '0' && c <= '9';
}

/// `text` as a double, HUGE_VAL where it is too large, 0 where too small; nullopt if no number.
std::optional<double> Wide(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    auto format = std::chars_format::general;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
        format = std::chars_format::hex;
    } else if (text.empty() || (!IsDigit(text[0]) && text[0] != '.')) {
        return {};  // from_chars would take "inf", "nan" and a second sign
    }
    if (text.starts_with('-') || text.starts_with('i') || text.starts_with('n')) return {};
    double value = 0;
    const auto [last, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, format);
    if (last != text.data() + text.size() || error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) {
        const size_t exponent = text.find_first_of(format == std::chars_format::hex ? "pP" : "eE");
        const bool tiny = exponent != text.npos && text.substr(exponent + 1).starts_with('-');
        value = tiny ? 0 : HUGE_VAL;
    }
    return negative ? -value : value;
}

}  // namespace

std::optional<float> ParseFloat(std::string_view text) {
    const char *first = text.data(), *last = first + text.size();
    float value = 0;
    if (ParseShortDecimal(first, last, &value) == last) return value;
    const char *digit = first != last && *first == '-' ? first + 1 : first;
    if (digit != last && (IsDigit(*digit) || *digit == '.')) {
        if (const std::optional<float> whole = ParseWhole<float>(text)) return whole;
    }
    const std::optional<double> wide = Wide(text);  // "+1", hexadecimal, out of float's range
    if (!wide || std::abs(*wide) > std::numeric_limits<float>::max()) return {};
    return float(*wide);
}

std::optional<int> ParseInt(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) return {};
    }
    return ParseWhole<int>(text);
}

std::string WhyNotFloat(std::string_view text) {
    if (Wide(text)) return fmt::format("\"{}\" is too large for a 32-bit float", text);
    return fmt::format("\"{}\" is not a number", text);
}

std::string WhyNotInt(std::string_view text) {
    const size_t sign = text.starts_with('-') || text.starts_with('+');
    if (text.size() > sign && text.find_first_not_of("0123456789", sign) == text.npos)
        return fmt::format("\"{}\" is too large for a 32-bit integer", text);
    return fmt::format("\"{}\" is not an integer", text);
}

}  // namespace pbrt
