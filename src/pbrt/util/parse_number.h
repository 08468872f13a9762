#pragma once

#include <optional>
#include <string_view>

namespace pbrt {

/// The whole of the text as a finite number, decimal, with or without a sign and an exponent;
/// nullopt for anything else. The same in every locale.
std::optional<double> ParseNumber(std::string_view text);

}  // namespace pbrt
