#include "pbrt/textures/wrinkled.h"

#include "pbrt/textures/octaves.h"

namespace pbrt {

FloatTexture WrinkledTexture::CreateFloat(TextureBuilder &builder) {
    return OctavesOfNoise(builder, Turbulence);
}

}  // namespace pbrt
