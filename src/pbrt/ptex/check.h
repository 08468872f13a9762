#pragma once

#include <string>

#include "pbrt/ptex/ptex.h"

namespace pbrt {

/// Why the content contradicts itself or the limits of the format; empty where all is well.
std::string WhatIsWrong(const PtexContent &content);

}  // namespace pbrt
