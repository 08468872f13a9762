#pragma once

#include "pbrt/feathergen/feather.h"
#include "pbrt/image/image.h"
#include "pbrt/ptex/ptex.h"

namespace pbrt::feathergen {

/// One number a face of VaneGrid: the mean over the quad. Tilts are moved from [-pi/2, pi/2] to
/// [0, 1], for textures of images hold no negative numbers.
struct VaneTextures {
    std::vector<float> thickness, spacing, tilt;

    explicit VaneTextures(const Feather &feather);
};

/// `values` as an image with one channel Y, v = 0 below.
Image Atlas(const Feather &feather, const std::vector<float> &values);

/// `values` as Ptex faces of one texel that know their neighbours, also across the ramus.
PtexContent Faces(const Feather &feather, const std::vector<float> &values);

}  // namespace pbrt::feathergen
