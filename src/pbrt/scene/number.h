#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pbrt {

/// Decimal (with exponent) or hexadecimal float: the whole of `text`, nearest float; values too
/// small for a float become 0. nullopt for anything else, infinities, NaN and values too large.
std::optional<float> ParseFloat(std::string_view text);
/// The number that [p, end) begins with, where it is a plain decimal of so few digits that one
/// division rounds it correctly: below 2^24 without its point, at most 10 digits after it (Clinger
/// 1990, section 3). The end of the number, or nullptr for anything else. Three times as fast as
/// std::from_chars, on which ParseFloat falls back; most numbers of scenes are so short.
inline const char *ParseShortDecimal(const char *p, const char *end, float *value) {
    constexpr float kPowers[] = {1e0f, 1e1f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f, 1e7f, 1e8f, 1e9f, 1e10f};
    constexpr int kMostDigits = 19;  // of 64 bits
    uint64_t number = 0;
    const auto readDigits = [&] {
        const char *const first = p;
        for (; p != end && *p >= '0' && *p <= '9'; ++p)
            number = 10 * number + uint64_t(*p - '0');
        return p - first;
    };
    const bool negative = p != end && *p == '-';
    p += negative;
    const ptrdiff_t whole = readDigits();
    ptrdiff_t decimals = 0;
    if (p != end && *p == '.') {
        ++p;
        decimals = readDigits();
    }
    const ptrdiff_t digits = whole + decimals;
    if (digits == 0 || digits > kMostDigits || number >= (1 << 24) || decimals > 10) return nullptr;
    const float size = float(number) / kPowers[decimals];
    *value = negative ? -size : size;
    return p;
}

/// Optional sign and decimal digits; nullopt for anything else and outside 32 bits.
std::optional<int> ParseInt(std::string_view text);

/// Why ParseFloat or ParseInt refused `text`, for a message: `"x" is not a number`.
std::string WhyNotFloat(std::string_view text);
std::string WhyNotInt(std::string_view text);

}  // namespace pbrt
