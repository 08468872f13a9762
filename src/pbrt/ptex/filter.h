#pragma once

#include <span>

#include "pbrt/ptex/texture.h"

namespace pbrt {

// PtexTexture::Lookup for the two kinds of mesh. uv inside the face, width in [0, 1], out not
// empty.

void LookupPtexQuad(const PtexTexture &texture, int face, Point2f uv, Vector2f width,
                    std::span<float> out);
void LookupPtexTriangle(const PtexTexture &texture, int face, Point2f uv, float width,
                        std::span<float> out);

/// out += weight times a texel's first channels, as they are stored.
template <typename T>
inline void AddTexel(const T *texel, float weight, std::span<float> out) {
    for (size_t c = 0; c < out.size(); ++c)
        out[c] += weight * float(texel[c]);
}
template <typename T>
inline void ScaleSum(float factor, std::span<float> out) {
    for (float &v : out)
        v *= factor * PtexScale<T>();
}

}  // namespace pbrt
