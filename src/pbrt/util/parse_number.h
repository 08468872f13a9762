#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

namespace pbrt {

/// The whole of the text as std::from_chars reads a T: "-2", no "+2" and no blanks, "nan" and "inf"
/// where T has them, nothing beyond its range. The same in every locale.
template <typename T>
std::optional<T> ParseWhole(std::string_view text) {
    T value{};
    const char *const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// The whole of the text as a finite number, decimal, with or without a sign and an exponent;
/// nullopt for anything else.
template <typename T = double>
std::optional<T> ParseNumber(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    const std::optional<T> value = ParseWhole<T>(text);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    return value;
}

}  // namespace pbrt
