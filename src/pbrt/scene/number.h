#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pbrt {

/// Decimal (with exponent) or hexadecimal float: the whole of `text`, nearest float; values too
/// small for a float become 0. nullopt for anything else, infinities, NaN and values too large.
std::optional<float> ParseFloat(std::string_view text);
/// Optional sign and decimal digits; nullopt for anything else and outside 32 bits.
std::optional<int> ParseInt(std::string_view text);

/// Why ParseFloat or ParseInt refused `text`, for a message: `"x" is not a number`.
std::string WhyNotFloat(std::string_view text);
std::string WhyNotInt(std::string_view text);

}  // namespace pbrt
