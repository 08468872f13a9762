#pragma once

#include <array>
#include <memory>
#include <string>

#include "pbrt/scene/params.h"
#include "pbrt/util/transform.h"

namespace pbrt {

/// A directive with its parameters, not yet interpreted.
struct Entity {
    std::string type;  ///< plug-in name; empty where the directive was not given
    FileLoc loc;
    ParsedParameters params;
    const RGBColorSpace *colorSpace = &RGBColorSpace::sRGB();
};

/// Object-to-world at the shutter's start and end.
using TransformPair = std::array<Transform, 2>;

struct ShapeEntity : Entity {
    TransformPair worldFromObject;
    bool reverseOrientation = false;
    std::string namedMaterial;  ///< set where NamedMaterial was current
    int material = -1;          ///< else index into SceneDescription::materials; -1: the default
    std::shared_ptr<const Entity> areaLight;  ///< null where none
};

/// ObjectInstance.
struct InstanceUse {
    std::string name;
    FileLoc loc;
    TransformPair worldFromInstance;
};

}  // namespace pbrt
