#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace pbrt::bsdftool {

/// The parts between separators, without blanks around them.
std::vector<std::string_view> SplitCells(std::string_view text, char separator);

/// The whole of the text as a number, with or without a sign; "nan" and "inf" are numbers too.
std::optional<double> ReadNumber(std::string_view text);

}  // namespace pbrt::bsdftool
