#include "pbrt/textures/fbm.h"

#include "pbrt/textures/octaves.h"

namespace pbrt {

FloatTexture FBmTexture::CreateFloat(TextureBuilder &builder) {
    return OctavesOfNoise(builder, FBm);
}

}  // namespace pbrt
