#include "pbrt/ptex/reduce.h"

namespace pbrt {

std::vector<float> HalfSize(PtexMesh mesh, const float *texels, int log2U, int log2V,
                            int nChannels) {
    const size_t width = size_t(1) << log2U, n = size_t(nChannels);
    const size_t newWidth = width / 2, newHeight = (size_t(1) << log2V) / 2;
    std::vector<float> half;
    half.reserve(newWidth * newHeight * n);
    for (size_t y = 0; y < newHeight; ++y)
        for (size_t x = 0; x < newWidth; ++x) {
            const float *cell = texels + (2 * y * width + 2 * x) * n;
            // The middle one of four small triangles is the inverted one of the mirrored cell.
            const float *far = mesh == PtexMesh::Quad
                                   ? cell + (width + 1) * n
                                   : texels + ((width - 1 - 2 * x) * width + width - 1 - 2 * y) * n;
            for (size_t c = 0; c < n; ++c)
                half.push_back((cell[c] + cell[n + c] + cell[width * n + c] + far[c]) / 4);
        }
    return half;
}

}  // namespace pbrt
