#include <algorithm>
#include <cmath>
#include <cstring>

#include "pbrt/ptex/texture.h"

namespace pbrt {
namespace {

template <typename T>
T Quantized(float v) {
    if constexpr (std::is_integral_v<T>)
        return T(std::lround(std::clamp(v, 0.f, 1.f) * std::numeric_limits<T>::max()));
    if constexpr (std::is_same_v<T, Imath::half>) return T(std::clamp(v, -65504.f, 65504.f));
    return T(v);
}

/// True where all `n` texels of `size` values agree.
template <typename T>
bool AllSame(const T *texels, size_t n, size_t size) {
    for (size_t i = size; i < n * size; ++i)
        if (texels[i] != texels[i - size]) return false;
    return true;
}

bool HasNeighbours(const PtexContent &content) {
    return std::any_of(content.faces.begin(), content.faces.end(), [](const PtexFace &face) {
        return face.neighbours != std::array<int, 4>{-1, -1, -1, -1};
    });
}

PtexNeighbours Compact(const PtexFace &face) {
    PtexNeighbours n;
    for (size_t e = 0; e < 4; ++e) {
        n.faces[e] = face.neighbours[e];
        n.edges |= uint8_t(face.neighbourEdges[e] << 2 * e);
    }
    return n;
}

bool IsUniform(const PtexData &data, int face) {
    const PtexTexels &texels = data.texels;
    if (!texels.IsConstant(face)) return false;
    const auto &around = data.neighbours[size_t(face)].faces;
    return std::all_of(around.begin(), around.end(), [&](int other) {
        return other < 0 || (texels.IsConstant(other) &&
                             std::memcmp(texels.Level(other, 0), texels.Level(face, 0),
                                         texels.PixelSize()) == 0);
    });
}

template <typename T>
void Fill(const PtexContent &content, PtexTexels *texels) {
    std::vector<T> values(content.texels.size());
    std::transform(content.texels.begin(), content.texels.end(), values.begin(), Quantized<T>);
    const size_t n = size_t(content.nChannels);
    const T *from = values.data();
    for (const PtexFace &face : content.faces) {
        texels->AddFace(face.log2U, face.log2V, AllSame(from, face.NTexels(), n));
        from += face.NTexels() * n;
    }
    texels->Allocate();
    from = values.data();
    for (int f = 0; f < texels->NFaces(); ++f) {
        std::memcpy(texels->Level(f, 0), from,
                    texels->IsConstant(f) ? texels->PixelSize() : texels->LevelBytes(f, 0));
        for (int level = 1; level < texels->NLevels(f); ++level)
            texels->Reduce(f, level);
        from += content.faces[size_t(f)].NTexels() * n;
    }
}

}  // namespace

PtexData PackPtex(const PtexContent &content) {
    PtexData data;
    data.texels = PtexTexels(content.mesh, content.type, content.nChannels);
    WithPtexType(content.type, [&](auto t) { Fill<decltype(t)>(content, &data.texels); });
    data.alphaChannel = content.alphaChannel;
    data.metadata = content.metadata;
    if (!HasNeighbours(content)) return data;
    std::transform(content.faces.begin(), content.faces.end(), std::back_inserter(data.neighbours),
                   Compact);
    for (int f = 0; f < data.texels.NFaces(); ++f)
        data.neighbours[size_t(f)].uniform = IsUniform(data, f);
    return data;
}

}  // namespace pbrt
