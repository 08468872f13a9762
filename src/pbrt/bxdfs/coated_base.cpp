#include "pbrt/bxdfs/coated_base.h"

#include <cmath>

#include "pbrt/bxdfs/fresnel.h"

namespace pbrt {
namespace {

constexpr int kAzimuths = 16, kHeights = 48;

Vector3f DirectionOf(float cosTheta) {
    const float c = std::max(cosTheta, 1e-4f);
    return {SafeSqrt(1 - Sqr(c)), 0, c};
}

/// Calls visit(m, share) for normals visible from w, whose azimuth is 0; the shares add to 1.
template <typename F>
void ForEachNormal(const TrowbridgeReitz &facets, Vector3f w, const F &visit) {
    // Normals at opposite azimuths mirror each other: half of them are enough.
    for (int i = 0; i < kAzimuths; ++i)
        for (int j = 0; j < kHeights; ++j)
            visit(facets.SampleVisibleNormal(
                      w, {(float(i) + 0.5f) / (2 * kAzimuths), (float(j) + 0.5f) / kHeights}),
                  1.f / (kAzimuths * kHeights));
}
/// Share of light from w that leaves along wi unshadowed, of what the facets send there.
float Unshadowed(const TrowbridgeReitz &facets, Vector3f w, Vector3f wi) {
    return facets.GOverCosines(w, wi) * std::abs(wi.z) / facets.G1OverCosine(w);
}

}  // namespace

/// Transport between a base of one width and its boundary, by the cosine of the angle inside.
class CoatedBase::Layers {
  public:
    Layers(const Coat &coat, float coatAlpha, float baseAlpha)
        : coat(coat),
          eta(coat.Eta()),
          depth(coat.Depth()),
          coatAlpha(coatAlpha),
          base(baseAlpha, baseAlpha) {
        const TrowbridgeReitz boundary(coatAlpha, coatAlpha);
        for (int i = 0; i < kCosines; ++i)
            fromBelow[size_t(i)] = BoundaryAt(boundary, CosineOf(i));
        for (int i = 0; i < kCosines; ++i)
            Reflect(i);
    }
    float Returned(int i) const {
        double sum = 0;
        for (const double share : arrives[size_t(i)])
            sum += share;
        return float(sum);
    }
    float Escape(int i) const {
        const double model = modelled[size_t(i)];
        return model > 0 ? float(leaves[size_t(i)] / model) : 1;
    }
    Later Sum() const;

  private:
    using PerCosine = std::array<double, kCosines>;
    struct Shares {
        float returned, leaves;
    };

    static float CosineOf(int i) { return float(i) / (kCosines - 1); }
    /// Calls visit(i, weight) for the two nodes about a cosine.
    template <typename F>
    static void AtNodes(float cosine, const F &visit) {
        const float x = std::clamp(cosine, 0.f, 1.f) * (kCosines - 1);
        const int i = std::min(int(x), kCosines - 2);
        visit(size_t(i), 1 - (x - float(i)));
        visit(size_t(i + 1), x - float(i));
    }
    /// Shares of light from below at a boundary. Its facets turn light by angles that average to
    /// those of a mirror, which is where returned light is counted.
    Shares BoundaryAt(const TrowbridgeReitz &boundary, float cosTheta) const {
        const Vector3f w = DirectionOf(cosTheta);
        if (boundary.IsSmooth()) {
            const auto [R, T] = FrDielectric(w.z, 1 / eta);
            return {R, T};
        }
        double returned = 0, leaves = 0;
        ForEachNormal(boundary, w, [&](Vector3f m, float share) {
            const float cos_o = std::min(1.f, Dot(w, m)), cos_t = CosTransmitted(cos_o, 1 / eta);
            const auto [R, T] = FrDielectric(cos_o, cos_t, 1 / eta);
            const Vector3f down = pbrt::Reflect(w, m), out = (cos_o * eta - cos_t) * m - w * eta;
            if (down.z > 0) returned += share * R * Unshadowed(boundary, w, down);
            if (T > 0 && out.z < 0) leaves += share * T * Unshadowed(boundary, w, out);
        });
        return {float(returned), float(leaves)};
    }
    /// One reflection of what arrives at node i: what arrives again, and what leaves.
    void Reflect(int i) {
        const Vector3f w = DirectionOf(CosineOf(i));
        PerCosine &again = arrives[size_t(i)];
        ForEachNormal(base, w, [&](Vector3f m, float normals) {
            const Vector3f up = pbrt::Reflect(w, m);
            if (!(up.z > 0)) return;
            const double share = normals * Unshadowed(base, w, up);
            const double pass = std::exp(-depth / up.z);
            const float cosOutside = CosTransmitted(std::min(up.z, 1.f), 1 / eta);
            if (cosOutside > 0)
                modelled[size_t(i)] += share * coat.From(cosOutside, coatAlpha).down;
            AtNodes(up.z, [&](size_t node, float weight) {
                again[node] += weight * share * fromBelow[node].returned * Sqr(pass);
                leaves[size_t(i)] += weight * share * fromBelow[node].leaves * pass;
            });
        });
    }

    const Coat &coat;
    float eta, depth, coatAlpha;
    TrowbridgeReitz base;
    std::array<Shares, kCosines> fromBelow;
    std::array<PerCosine, kCosines> arrives{};
    PerCosine leaves{}, modelled{};
};

CoatedBase::Later CoatedBase::Layers::Sum() const {
    const auto reflected = [&](const PerCosine &light) {
        PerCosine next{};
        for (size_t i = 0; i < kCosines; ++i)
            for (size_t j = 0; j < kCosines; ++j)
                next[j] += light[i] * arrives[i][j];
        return next;
    };
    const auto total = [](const PerCosine &light) {
        double sum = 0;
        for (const double share : light)
            sum += share;
        return sum;
    };
    PerCosine light{};
    constexpr int kDirections = 64;
    for (int i = 0; i < kDirections; ++i) {
        const float cosOutside = std::sqrt((float(i) + 0.5f) / kDirections);
        const float cosInside = CosTransmitted(cosOutside, eta);
        const float T = FrDielectric(cosOutside, cosInside, eta).T;
        AtNodes(cosInside, [&](size_t node, float weight) {
            light[node] += weight * T * std::exp(-depth / cosInside) / kDirections;
        });
    }
    light = reflected(light);
    Later later{float(total(light)), {}, 0};
    if (later.twice == 0) return later;
    for (double &share : light)
        share /= later.twice;
    for (float &share : later.leaves) {
        double sum = 0;
        for (size_t i = 0; i < kCosines; ++i)
            sum += light[i] * leaves[i];
        share = float(sum);
        const double before = total(light);
        light = reflected(light);
        later.ratio = before > 0 ? float(total(light) / before) : 0;
    }
    return later;
}

CoatedBase::CoatedBase(const Coat &coat, float coatAlpha, float alphaMin, float alphaMax)
    : rootMin(std::sqrt(alphaMin)) {
    constexpr int kColumns = 12;
    if (alphaMax > alphaMin) {
        nColumns = kColumns;
        rootStep = (std::sqrt(alphaMax) - rootMin) / (kColumns - 1);
    }
    for (int column = 0; column < nColumns; ++column) {
        const Layers layers(coat, coatAlpha, AlphaOf(column));
        for (int i = 0; i < kCosines; ++i) {
            returned.push_back(layers.Returned(i));
            escape.push_back(layers.Escape(i));
        }
        later.push_back(layers.Sum());
    }
}

}  // namespace pbrt
