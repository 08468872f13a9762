#include "pbrt/ptex/texture.h"

#include <algorithm>

#include "pbrt/ptex/filter.h"

namespace pbrt {
namespace {

/// Also for NaN: 0.
float ClampToUnit(float x) {
    return x > 0 ? std::min(x, 1.f) : 0.f;
}

PtexFace FaceOf(const PtexTexture &texture, int face) {
    PtexFace f{texture.Texels().Log2U(face), texture.Texels().Log2V(face)};
    if (const PtexNeighbours *around = texture.Neighbours(face))
        for (int e = 0; e < 4; ++e) {
            f.neighbours[size_t(e)] = around->faces[size_t(e)];
            f.neighbourEdges[size_t(e)] = around->Edge(e);
        }
    return f;
}

}  // namespace

PtexTexture::PtexTexture(PtexData d) : data(std::move(d)), flat(data.neighbours.empty()) {
    for (int f = 0; f < NFaces() && flat; ++f)
        flat = data.texels.IsConstant(f);
    for (PtexNeighbours &around : data.neighbours)
        for (int &other : around.faces)
            if (other >= 0 && data.neighbours[size_t(other)].subface != around.subface) other = -1;
}

size_t PtexTexture::MemoryBytes() const {
    return data.texels.MemoryBytes() + data.neighbours.capacity() * sizeof(PtexNeighbours);
}

float PtexTexture::Texel(int face, int level, Point2i p, int channel) const {
    const PtexTexels &texels = data.texels;
    DCHECK(face >= 0 && face < NFaces() && level >= 0 && level < NLevels(face));
    const size_t width = size_t(1) << std::max(texels.Log2U(face) - level, 0);
    const size_t texel = texels.IsConstant(face) ? 0 : size_t(p.y) * width + size_t(p.x);
    return WithPtexType(Type(), [&](auto t) {
        using T = decltype(t);
        const T *grid = texels.LevelAs<T>(face, level);
        return float(grid[texel * size_t(NChannels()) + size_t(channel)]) * PtexScale<T>();
    });
}

void PtexTexture::Lookup(int face, Point2f uv, Vector2f width, std::span<float> out) const {
    DCHECK(!out.empty() && out.size() <= size_t(NChannels()));
    std::fill(out.begin(), out.end(), 0.f);
    if (face < 0 || face >= NFaces()) return;
    const PtexNeighbours *around = Neighbours(face);
    if (data.texels.IsConstant(face) && (!around || around->uniform)) {
        WithPtexType(Type(), [&](auto t) {
            AddTexel(data.texels.LevelAs<decltype(t)>(face, 0), PtexScale<decltype(t)>(), out);
        });
        return;
    }
    uv = {ClampToUnit(uv.x), ClampToUnit(uv.y)};
    width = {ClampToUnit(width.x), ClampToUnit(width.y)};
    if (Mesh() == PtexMesh::Quad) return LookupPtexQuad(*this, face, uv, width, out);
    uv.y = std::min(uv.y, 1 - uv.x);
    LookupPtexTriangle(*this, face, uv, std::max(width.x, width.y), out);
}

PtexContent PtexTexture::Content() const {
    PtexContent content{Mesh(), Type(), NChannels(), AlphaChannel(), {}, {}, Metadata()};
    for (int f = 0; f < NFaces(); ++f) {
        const PtexFace face = FaceOf(*this, f);
        content.faces.push_back(face);
        for (int y = 0; y < 1 << face.log2V; ++y)
            for (int x = 0; x < 1 << face.log2U; ++x)
                for (int c = 0; c < NChannels(); ++c)
                    content.texels.push_back(Texel(f, 0, {x, y}, c));
    }
    return content;
}

}  // namespace pbrt
