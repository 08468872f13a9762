#pragma once

#include <string>
#include <string_view>

#include "pbrt/util/result.h"

namespace pbrt {

/// `text` with the number of a frame in the place of each `$frame`, and values in the place of each
/// `$(...)`: a linear expression of `frame` with + - * / and parentheses, as `$(7.5 * (frame -
/// 1))`. Whole values are written without a point. In scene text that stands in comments stays as
/// it is. The error says what about an expression is wrong, and in which line.
OrError<std::string> PutFrame(std::string_view text, int frame);
/// The same for a name, where # begins no comment.
OrError<std::string> PutFrameInName(std::string_view name, int frame);
/// True where there is something for PutFrameInName to replace.
bool NamesFrame(std::string_view name);

}  // namespace pbrt
