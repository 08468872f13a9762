#pragma once

#include <map>
#include <memory>
#include <string>

#include "pbrt/base/ray_tracer.h"
#include "pbrt/lights/light_picture.h"
#include "pbrt/shapes/shapes.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// Pictures of area lights by their files; null for those that do not serve.
using LightPictures = std::map<std::string, std::shared_ptr<const LightPicture>>;

/// A surface that area lights are made for.
struct EmitterArguments {
    const Shape &shape;  ///< outlives the lights, as does `motion`
    FloatTexture alpha = 1.f;
    const Instance *motion = nullptr;   ///< carries the shape; null: it rests where it is
    LightPictures *pictures = nullptr;  ///< read before; null: none are kept
};

}  // namespace pbrt
