#pragma once

#include "pbrt/textures/noise.h"
#include "pbrt/textures/texture_builder.h"

namespace pbrt {

/// A sum of octaves at the point in texture space: FBm or Turbulence. Reads `octaves` and
/// `roughness`.
FloatTexture OctavesOfNoise(TextureBuilder &builder, decltype(FBm) *sum);

}  // namespace pbrt
