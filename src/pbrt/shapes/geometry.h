#pragma once

#include "pbrt/shapes/shapes.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// A shape with all that the ray tracer must know of it.
struct Geometry {
    Shape shape;
    int material = 0;                  ///< index into RenderScene::materials
    int firstLight = -1;               ///< light of primitive 0; -1: not emissive
    bool sharedLight = false;          ///< all primitives are parts of that one light
    bool hasNullTransmission = false;  ///< surface with gaps: shadow rays ask for its transmittance
    FloatTexture alpha = 1.f;          ///< constant 1: no test
};

}  // namespace pbrt
