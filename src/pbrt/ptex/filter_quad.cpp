#include <algorithm>
#include <cmath>

#include "pbrt/ptex/filter.h"

namespace pbrt {
namespace {

/// A cell of face `face` cut into 2^log2U x 2^log2V cells.
struct Cell {
    int face, x, y, log2U, log2V;
};

/// Moves the cell across `edge` into the face behind, whose (u, v) may be turned by quarters: its
/// edge e + turn is this face's e. False where there is no neighbour to go to.
bool Cross(const PtexTexture &texture, int edge, Cell *c) {
    const PtexNeighbours *around = texture.Neighbours(c->face);
    if (!around) return false;
    const int neighbour = around->faces[size_t(edge)];
    if (neighbour < 0) return false;
    const int nU = 1 << c->log2U, nV = 1 << c->log2V;
    const int x = c->x + (edge == 3 ? nU : edge == 1 ? -nU : 0);
    const int y = c->y + (edge == 0 ? nV : edge == 2 ? -nV : 0);
    switch ((around->Edge(edge) + 2 - edge) & 3) {
        case 0:
            *c = {neighbour, x, y, c->log2U, c->log2V};
            return true;
        case 1:
            *c = {neighbour, nV - 1 - y, x, c->log2V, c->log2U};
            return true;
        case 2:
            *c = {neighbour, nU - 1 - x, nV - 1 - y, c->log2U, c->log2V};
            return true;
        default:
            *c = {neighbour, y, nU - 1 - x, c->log2V, c->log2U};
            return true;
    }
}

/// Brings a cell that lies less than one face outside into the face it lies in, first along u.
Cell Inside(const PtexTexture &texture, Cell c) {
    for (int crossings = 0; crossings < 2; ++crossings) {
        const int nU = 1 << c.log2U, nV = 1 << c.log2V;
        if (c.x < 0 || c.x >= nU) {
            if (!Cross(texture, c.x < 0 ? 3 : 1, &c)) c.x = std::clamp(c.x, 0, nU - 1);
        } else if (c.y < 0 || c.y >= nV) {
            if (!Cross(texture, c.y < 0 ? 0 : 2, &c)) c.y = std::clamp(c.y, 0, nV - 1);
        }
    }
    c.x = std::clamp(c.x, 0, (1 << c.log2U) - 1);
    c.y = std::clamp(c.y, 0, (1 << c.log2V) - 1);
    return c;
}

/// The mean over a cell inside its face. Where the face is finer along one side only, up to eight
/// texels are summed there; the rest is left to coarser levels.
template <typename T>
void AddCell(const PtexTexels &texels, const Cell &c, float weight, std::span<float> out) {
    const size_t n = size_t(texels.NChannels());
    if (texels.IsConstant(c.face)) return AddTexel(texels.LevelAs<T>(c.face, 0), weight, out);
    if (texels.Log2U(c.face) == c.log2U && texels.Log2V(c.face) == c.log2V)
        return AddTexel(texels.LevelAs<T>(c.face, 0) + ((size_t(c.y) << c.log2U) + size_t(c.x)) * n,
                        weight, out);
    const int finerU = texels.Log2U(c.face) - c.log2U, finerV = texels.Log2V(c.face) - c.log2V;
    const int level = std::clamp(std::min(finerU, finerV), std::max({finerU, finerV, 3}) - 3,
                                 texels.NLevels(c.face) - 1);
    const int u = std::max(texels.Log2U(c.face) - level, 0);
    const int v = std::max(texels.Log2V(c.face) - level, 0);
    const int moreU = std::max(u - c.log2U, 0), moreV = std::max(v - c.log2V, 0);
    const size_t x = size_t(c.x) << moreU >> std::max(c.log2U - u, 0);
    const size_t y = size_t(c.y) << moreV >> std::max(c.log2V - v, 0);
    const T *first = texels.LevelAs<T>(c.face, level) + ((y << u) + x) * n;
    weight /= float(1 << (moreU + moreV));
    for (size_t dy = 0; dy < size_t(1) << moreV; ++dy)
        for (size_t dx = 0; dx < size_t(1) << moreU; ++dx)
            AddTexel(first + ((dy << u) + dx) * n, weight, out);
}

/// Weights of consecutive texels along one side.
struct AxisTaps {
    static constexpr int kMost = 12;  ///< 8 + 2, and room for rounding
    int first, count;
    std::array<float, kMost> weight;
};

/// `center` and `width` <= 8 of the box in texels, texel i centered at i + 1/2.
AxisTaps MakeTaps(float center, float width) {
    const float lo = center - 0.5f - width / 2, hi = center - 0.5f + width / 2, size = hi - lo;
    AxisTaps taps{int(std::floor(lo)), 1, {}};
    // Between two texel centers the interpolation is linear: its mean is that at the middle.
    for (int k = taps.first; float(k) <= hi; ++k, ++taps.count) {
        const float a = std::max(lo, float(k)), b = std::min(hi, float(k) + 1);
        const float share = size > 0 ? (b - a) / size : 1, middle = (a + b) / 2 - float(k);
        taps.weight[size_t(k - taps.first)] += share * (1 - middle);
        taps.weight[size_t(k - taps.first) + 1] = share * middle;
    }
    return taps;
}

template <typename T>
void Lookup(const PtexTexture &texture, int face, Point2f uv, Vector2f width,
            std::span<float> out) {
    const PtexTexels &texels = texture.Texels();
    int log2U = texels.Log2U(face), log2V = texels.Log2V(face), level = 0;
    float a = width.x * float(1 << log2U), b = width.y * float(1 << log2V);
    if (texels.IsConstant(face)) log2U = log2V = 0, a = width.x, b = width.y;
    while (log2U + log2V > 0 && (std::max(a, b) > 8 || std::min(a, b) >= 2)) {
        if (log2U > 0) --log2U, a /= 2;
        if (log2V > 0) --log2V, b /= 2;
        ++level;
    }
    const int nU = 1 << log2U, nV = 1 << log2V;
    const AxisTaps u = MakeTaps(uv.x * float(nU), a), v = MakeTaps(uv.y * float(nV), b);
    const T *grid = texels.LevelAs<T>(face, level);
    const size_t n = size_t(texels.NChannels());
    for (int j = 0; j < v.count; ++j)
        for (int i = 0; i < u.count; ++i) {
            const int x = u.first + i, y = v.first + j;
            const float weight = u.weight[size_t(i)] * v.weight[size_t(j)];
            if (unsigned(x) < unsigned(nU) && unsigned(y) < unsigned(nV))
                AddTexel(grid + (size_t(y) * size_t(nU) + size_t(x)) * n, weight, out);
            else if (weight != 0)
                AddCell<T>(texels, Inside(texture, {face, x, y, log2U, log2V}), weight, out);
        }
    ScaleSum<T>(1, out);
}

}  // namespace

void LookupPtexQuad(const PtexTexture &texture, int face, Point2f uv, Vector2f width,
                    std::span<float> out) {
    WithPtexType(texture.Type(),
                 [&](auto t) { Lookup<decltype(t)>(texture, face, uv, width, out); });
}

}  // namespace pbrt
