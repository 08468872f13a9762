#pragma once

#include <cmath>
#include <vector>

#include "pbrt/bxdfs/fresnel.h"

namespace pbrt {

/// A dielectric coat as the diffuse base under it knows it: how much light gets through, how much
/// of what the base sends up comes back. A diffuse base forgets directions, so with these numbers
/// all orders of reflection between base and coat are a geometric series.
///
/// The boundary is smooth or has Trowbridge-Reitz facets that scatter once; the layer absorbs. For
/// a smooth boundary in closed form but for the integrals over the hemisphere, for rough ones from
/// tables; errors below 1e-3 of all light, where the roughness is a constant below 3e-4
/// (test/bxdf/coated_diffuse_test.cpp).
class Coat {
  public:
    /// eta >= 1: index of the layer; depth >= 0: its optical depth at normal incidence; the facets'
    /// alphas, a mirror where both are below kSmooth.
    Coat(float eta, float depth, float alphaX, float alphaY);
    /// For alphas that textures vary, up to kRoughest, beyond which they count as that.
    static Coat ForTextures(float eta, float depth);

    static constexpr float kSmooth = 1e-3f, kRoughest = 2;

    /// Split of the light that comes from one direction outside.
    struct Split {
        float down;  ///< arrives at the base for the first time
        float back;  ///< reflected by the boundary
    };
    /// alpha: width of the facets' slopes in the plane of the direction and the normal.
    Split From(float cosTheta, float alpha) const;
    /// The same of light from all directions evenly, and what the base gets back of its own.
    struct Averages {
        float down, returned;
    };
    Averages Mean(float alpha) const;
    float Eta() const { return eta; }
    float Depth() const { return depth; }

  private:
    static constexpr int kCosines = 64;  ///< nodes at the squares of equal steps: close at grazing
    struct Column {
        int first;
        float t;
    };
    class Boundary;

    Coat(float eta, float depth) : eta(eta), depth(depth) {}
    void SetColumns(float alphaMin, float alphaMax, int n);
    float AlphaOf(int column) const { return Sqr(rootMin + float(column) * rootStep); }
    void AddColumn(const Boundary &boundary);
    Averages MeanOver(const Boundary &boundary, float alpha) const;
    Split Smooth(float cosTheta) const;
    Averages SmoothMean() const;
    /// Place of alpha between columns, which are evenly spaced in its root.
    Column ColumnOf(float alpha) const;
    Split InColumn(int column, float cosTheta) const;

    float eta, depth;
    float smoothBelow = kSmooth;
    float rootMin = 0, rootStep = 1;
    int nColumns = 0;
    std::vector<Split> shares;    ///< kCosines per column
    std::vector<Averages> means;  ///< per column
    Averages smoothMean{};
};

inline Coat::Split Coat::Smooth(float cosTheta) const {
    const float cos_t = CosTransmitted(cosTheta, eta);
    const auto [R, T] = FrDielectric(cosTheta, cos_t, eta);
    return {cos_t > 0 ? T * std::exp(-depth / cos_t) : 0, R};
}

inline Coat::Column Coat::ColumnOf(float alpha) const {
    const float x = std::clamp((std::sqrt(alpha) - rootMin) / rootStep, 0.f, float(nColumns - 1));
    const int first = std::min(int(x), std::max(0, nColumns - 2));
    return {first, x - float(first)};
}

inline Coat::Split Coat::InColumn(int column, float cosTheta) const {
    const float x = std::sqrt(std::min(cosTheta, 1.f)) * (kCosines - 1);
    const int i = std::min(int(x), kCosines - 2);
    const float t = x - float(i);
    const Split &a = shares[size_t(column * kCosines + i)], &b = (&a)[1];
    return {Lerp(t, a.down, b.down), Lerp(t, a.back, b.back)};
}

inline Coat::Split Coat::From(float cosTheta, float alpha) const {
    if (alpha < smoothBelow) return Smooth(cosTheta);
    const auto [first, t] = ColumnOf(alpha);
    const Split a = InColumn(first, cosTheta);
    if (t == 0) return a;
    const Split b = InColumn(first + 1, cosTheta);
    return {Lerp(t, a.down, b.down), Lerp(t, a.back, b.back)};
}

inline Coat::Averages Coat::Mean(float alpha) const {
    if (alpha < smoothBelow) return smoothMean;
    const auto [first, t] = ColumnOf(alpha);
    const Averages &a = means[size_t(first)];
    if (t == 0) return a;
    const Averages &b = means[size_t(first + 1)];
    return {Lerp(t, a.down, b.down), Lerp(t, a.returned, b.returned)};
}

}  // namespace pbrt
