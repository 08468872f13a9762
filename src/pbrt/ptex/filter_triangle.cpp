#include <algorithm>
#include <array>
#include <cmath>

#include "pbrt/ptex/filter.h"

namespace pbrt {
namespace {

/// The kernel exp(-2 (r / width)^2) ends at r = 1.75 width, r and width measured in a face with
/// equilateral corners and sides of 1. Fits the real library's look-ups to 1e-7 (test/ptex).
constexpr float kReach = 1.75f;

/// A point of a face's plane: how far it lies from edges 0, 1 and 2, the corner opposite being 1.
struct Barycentric {
    int face;
    std::array<float, 3> fromEdge;  ///< v, 1 - u - v, u
};

/// Unfolds the face behind `edge`: the same point in the coordinates of the face there, of which
/// it is edge `to`. Both faces run round their edges the same way, so that one's start is the
/// other's end.
Barycentric Behind(const Barycentric &p, int edge, int neighbour, int to) {
    // Edge e starts at the corner opposite to edge e + 1 and ends at that opposite to e + 2.
    const float depth = p.fromEdge[size_t(edge)];
    const float start = p.fromEdge[size_t((edge + 1) % 3)];
    const float end = p.fromEdge[size_t((edge + 2) % 3)];
    Barycentric q{neighbour, {}};
    q.fromEdge[size_t(to)] = -depth;
    q.fromEdge[size_t((to + 1) % 3)] = end + depth;
    q.fromEdge[size_t((to + 2) % 3)] = start + depth;
    return q;
}

/// Brings p into the face it lies in; false where no face is there or it lies too far round a
/// corner.
bool FindFace(const PtexTexture &texture, Barycentric *p) {
    for (int crossings = 0; crossings < 4; ++crossings) {
        const auto least = std::min_element(p->fromEdge.begin(), p->fromEdge.end());
        if (*least >= 0) return true;
        const int edge = int(least - p->fromEdge.begin());
        const PtexNeighbours *around = texture.Neighbours(p->face);
        if (!around || around->faces[size_t(edge)] < 0) return false;
        *p = Behind(*p, edge, around->faces[size_t(edge)], around->Edge(edge));
    }
    return false;
}

/// The texel that holds p, which lies inside its face, on the level of resolution 2^log2 or the
/// finest.
template <typename T>
const T *TexelAt(const PtexTexels &texels, const Barycentric &p, int log2) {
    if (texels.IsConstant(p.face)) return texels.LevelAs<T>(p.face, 0);
    const int level = std::max(texels.Log2U(p.face) - log2, 0);
    const int n = 1 << (texels.Log2U(p.face) - level);
    const float u = p.fromEdge[2] * float(n), v = p.fromEdge[0] * float(n);
    int x = std::min(int(u), n - 1), y = std::min(int(v), n - 1);
    if (u - float(x) + v - float(y) > 1) {
        const int mirrored = n - 1 - x;
        x = n - 1 - y;
        y = mirrored;
    }
    return texels.LevelAs<T>(p.face, level) +
           (size_t(y) * size_t(n) + size_t(x)) * size_t(texels.NChannels());
}

template <typename T>
void Lookup(const PtexTexture &texture, int face, Point2f uv, float width, std::span<float> out) {
    const PtexTexels &texels = texture.Texels();
    int log2 = texels.IsConstant(face) ? 0 : texels.Log2U(face);
    while (log2 > 0 && width * float(1 << log2) >= 2)
        --log2;
    const int n = 1 << log2;
    const float w = std::max(width * float(n), 1.f), reach = kReach * w;
    // A disk of this reach spans 2 / sqrt(3) times as much along the slanted axes.
    const float span = reach * 1.1547006f;
    const Point2f at{uv.x * float(n), uv.y * float(n)};
    float sum = 0;
    for (int y = int(std::floor(at.y - span)); float(y) < at.y + span; ++y)
        for (int x = int(std::floor(at.x - span)); float(x) < at.x + span; ++x)
            for (const float third : {1 / 3.f, 2 / 3.f}) {
                const float u = float(x) + third, v = float(y) + third;
                const float du = u - at.x, dv = v - at.y, r2 = du * du + dv * dv + du * dv;
                if (!(r2 < reach * reach)) continue;
                Barycentric p{face, {v / float(n), 1 - (u + v) / float(n), u / float(n)}};
                if (!FindFace(texture, &p)) continue;
                const float weight = std::exp(-2 * r2 / (w * w));
                AddTexel(TexelAt<T>(texels, p, log2), weight, out);
                sum += weight;
            }
    ScaleSum<T>(1 / sum, out);
}

}  // namespace

void LookupPtexTriangle(const PtexTexture &texture, int face, Point2f uv, float width,
                        std::span<float> out) {
    WithPtexType(texture.Type(),
                 [&](auto t) { Lookup<decltype(t)>(texture, face, uv, width, out); });
}

}  // namespace pbrt
