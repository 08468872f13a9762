#pragma once

#include <array>
#include <cstdint>

#include "pbrt/scene/entities.h"

namespace pbrt {

/// 128 bits of what a directive says: type, parameters and color spaces, but not the places where
/// they stand. Among a million different directives two share one with a probability of 2e-27.
using ContentHash = std::array<uint64_t, 2>;
ContentHash HashContent(const Entity &entity);

}  // namespace pbrt
