#pragma once

#include <array>
#include <vector>

#include "pbrt/bxdfs/coat.h"
#include "pbrt/bxdfs/microfacet.h"
#include "pbrt/spectra/sampled_spectrum.h"

namespace pbrt {

/// A glossy base under a coat, as the light knows it that the coat's boundary sends back down:
/// shares for a base that reflects all, from quadrature over the facets of both.
class CoatedBase {
  public:
    /// coatAlpha: width of the coat's facets; then the widths that the base's lobes may have,
    /// between which shares are interpolated.
    CoatedBase(const Coat &coat, float coatAlpha, float alphaMin, float alphaMax);

    /// Share of light arriving at the base at this angle inside the coat that the base reflects,
    /// the boundary returns and that arrives at the base again.
    float Returned(float cosInside, float alpha) const { return At(returned, cosInside, alpha); }
    /// Share of such light that leaves after one reflection, over what Coat::From says of the
    /// directions outside that the base's mirrored light is refracted to: below 1 where the
    /// boundary's facets turn it back or stand in its way.
    float Escape(float cosInside, float alpha) const { return At(escape, cosInside, alpha); }
    /// Averages over light that comes in from all directions evenly.
    struct Later {
        static constexpr int kOrders = 6;
        float twice;  ///< share of all light that arrives at the base a second time
        /// Shares of that which leave after each further reflection; the rest falls by `ratio`.
        std::array<float, kOrders> leaves;
        float ratio;

        /// Share of it that leaves in all where each reflection keeps F.
        SampledSpectrum Sum(SampledSpectrum F) const;
    };
    Later Mean(float alpha) const;

  private:
    static constexpr int kCosines = 33;
    struct Place {
        int first;
        float t;
    };
    class Layers;

    float AlphaOf(int column) const { return Sqr(rootMin + float(column) * rootStep); }
    Place PlaceOf(float alpha) const;
    float At(const std::vector<float> &table, float cosInside, float alpha) const;

    float rootMin, rootStep = 1;
    int nColumns = 1;
    std::vector<float> returned, escape;  ///< kCosines per column, at equal steps of the cosine
    std::vector<Later> later;             ///< per column
};

inline CoatedBase::Place CoatedBase::PlaceOf(float alpha) const {
    const float x = std::clamp((std::sqrt(alpha) - rootMin) / rootStep, 0.f, float(nColumns - 1));
    const int first = std::min(int(x), std::max(0, nColumns - 2));
    return {first, x - float(first)};
}

inline float CoatedBase::At(const std::vector<float> &table, float cosInside, float alpha) const {
    const auto [first, t] = PlaceOf(alpha);
    const float x = std::min(cosInside, 1.f) * (kCosines - 1);
    const int i = std::min(int(x), kCosines - 2);
    const auto in = [&](int column) {
        const float *const at = &table[size_t(column * kCosines + i)];
        return Lerp(x - float(i), at[0], at[1]);
    };
    return t == 0 ? in(first) : Lerp(t, in(first), in(first + 1));
}

inline CoatedBase::Later CoatedBase::Mean(float alpha) const {
    const auto [first, t] = PlaceOf(alpha);
    Later mean = later[size_t(first)];
    if (t == 0) return mean;
    const Later &b = later[size_t(first + 1)];
    mean.twice = Lerp(t, mean.twice, b.twice);
    mean.ratio = Lerp(t, mean.ratio, b.ratio);
    for (size_t k = 0; k < mean.leaves.size(); ++k)
        mean.leaves[k] = Lerp(t, mean.leaves[k], b.leaves[k]);
    return mean;
}

inline SampledSpectrum CoatedBase::Later::Sum(SampledSpectrum F) const {
    SampledSpectrum sum = SampledSpectrum(leaves.back()) / (SampledSpectrum(1) - ratio * F);
    for (int k = kOrders - 2; k >= 0; --k)
        sum = SampledSpectrum(leaves[size_t(k)]) + F * sum;
    return F * F * sum;
}

}  // namespace pbrt
