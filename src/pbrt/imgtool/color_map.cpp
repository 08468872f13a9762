#include "pbrt/imgtool/color_map.h"

#include <algorithm>
#include <cmath>

namespace pbrt::imgtool {
namespace {

/// Matplotlib's viridis (N. Smith, S. van der Walt, 2015; in the public domain) at every sixteenth
/// of its length.
constexpr std::array<std::array<float, 3>, 17> kViridis{{{0.267f, 0.005f, 0.329f},
                                                         {0.282f, 0.095f, 0.417f},
                                                         {0.279f, 0.175f, 0.483f},
                                                         {0.259f, 0.251f, 0.524f},
                                                         {0.230f, 0.321f, 0.545f},
                                                         {0.200f, 0.386f, 0.555f},
                                                         {0.173f, 0.447f, 0.558f},
                                                         {0.150f, 0.506f, 0.557f},
                                                         {0.128f, 0.565f, 0.551f},
                                                         {0.120f, 0.624f, 0.534f},
                                                         {0.155f, 0.682f, 0.503f},
                                                         {0.241f, 0.737f, 0.455f},
                                                         {0.363f, 0.787f, 0.387f},
                                                         {0.508f, 0.829f, 0.299f},
                                                         {0.669f, 0.862f, 0.195f},
                                                         {0.836f, 0.886f, 0.102f},
                                                         {0.993f, 0.906f, 0.144f}}};

}  // namespace

std::array<float, 3> Viridis(float x) {
    const float at = x > 0 ? std::min(x, 1.f) * float(kViridis.size() - 1) : 0;
    const size_t i = std::min(size_t(at), kViridis.size() - 2);
    std::array<float, 3> color;
    for (size_t c = 0; c < 3; ++c)
        color[c] = std::lerp(kViridis[i][c], kViridis[i + 1][c], at - float(i));
    return color;
}

}  // namespace pbrt::imgtool
