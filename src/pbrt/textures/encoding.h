#pragma once

#include <optional>

#include "pbrt/image/image.h"
#include "pbrt/scene/params.h"

namespace pbrt {

/// `"string encoding"`: "sRGB", "linear" or "gamma x"; nullopt where it was not given or, after an
/// error, is none of these.
std::optional<ColorEncoding> GetEncoding(ParamDict &params);

}  // namespace pbrt
