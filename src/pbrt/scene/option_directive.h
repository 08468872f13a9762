#pragma once

#include "pbrt/scene/directive_context.h"

namespace pbrt {

/// `Option "name" value` (PBRT_FORMAT 1.4).
void ReadOption(DirectiveContext &c);

}  // namespace pbrt
