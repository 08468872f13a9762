#pragma once

#include <optional>
#include <variant>

#include "pbrt/lights/image_infinite.h"
#include "pbrt/lights/uniform_infinite.h"

namespace pbrt {

/// Reads `LightSource "infinite"`: constant without `filename`, by image with. nullopt after an
/// error that leaves no light.
std::optional<std::variant<UniformInfiniteLight, ImageInfiniteLight>> CreateInfiniteLight(
    ParamDict &params, const Transform &renderFromLight);

}  // namespace pbrt
