#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pbrt/reference/families.h"

namespace pbrt::reference {

/// The plug-in as a scene names it: `Material "diffuse"`.
std::string Call(const Family &family, std::string_view type);

/// Columns for a terminal: name, types, unit, default and range, and the meaning below, in lines of
/// at most 100 characters where the columns leave room for it.
std::string TextTable(std::span<const RequestedParam> params);

/// `## Title`, between empty lines.
std::string MarkdownHeading(int level, std::string_view title);
std::string MarkdownTable(std::span<const RequestedParam> params);

}  // namespace pbrt::reference
