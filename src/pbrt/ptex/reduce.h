#pragma once

#include <vector>

#include "pbrt/ptex/ptex.h"

namespace pbrt {

/// A face's texels (as in PtexContent) at half the resolution along u and v, both exponents above
/// 0: means of the four texels that a texel of the result covers.
std::vector<float> HalfSize(PtexMesh mesh, const float *texels, int log2U, int log2V,
                            int nChannels);

}  // namespace pbrt
