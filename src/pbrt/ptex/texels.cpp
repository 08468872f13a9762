#include "pbrt/ptex/texels.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pbrt {
namespace {

template <typename T>
T Rounded(float v) {
    if constexpr (std::is_integral_v<T>) return T(v + 0.5f);
    return T(v);
}

/// Means of the four (two, where a side has one texel) texels that one of the result covers.
template <typename T>
void HalfSize(PtexMesh mesh, const T *from, int log2U, int log2V, size_t n, T *to) {
    const size_t width = size_t(1) << log2U, height = size_t(1) << log2V;
    const size_t right = width > 1 ? n : 0, up = height > 1 ? width * n : 0;
    for (size_t y = 0; y < height; y += 2)
        for (size_t x = 0; x < width; x += 2) {
            const T *cell = from + (y * width + x) * n;
            // The middle one of four small triangles is the inverted one of the mirrored cell.
            const T *far = mesh == PtexMesh::Quad
                               ? cell + right + up
                               : from + ((width - 1 - x) * width + width - 1 - y) * n;
            for (size_t c = 0; c < n; ++c)
                *to++ = Rounded<T>((float(cell[c]) + float(cell[right + c]) + float(cell[up + c]) +
                                    float(far[c])) /
                                   4);
        }
}

}  // namespace

void PtexTexels::AddFace(int log2U, int log2V, bool constant) {
    faces.push_back({nTexels, int8_t(log2U), int8_t(log2V), constant});
    const int face = NFaces() - 1;
    nTexels += constant ? 1 : LevelBegin(face, NLevels(face));
}

void PtexTexels::Reduce(int face, int level) {
    DCHECK(level > 0 && level < NLevels(face));
    const int u = std::max(Log2U(face) - level + 1, 0), v = std::max(Log2V(face) - level + 1, 0);
    WithPtexType(type, [&](auto t) {
        using T = decltype(t);
        HalfSize(mesh, LevelAs<T>(face, level - 1), u, v, size_t(nChannels),
                 reinterpret_cast<T *>(Level(face, level)));
    });
}

}  // namespace pbrt
