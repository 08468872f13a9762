#pragma once

#include <string>
#include <vector>

#include "pbrt/scene/params.h"

namespace pbrt {

/// What film `spectral` keeps beside R, G and B: mean radiance in `nbuckets` equal parts of
/// [lambdamin, lambdamax] nm, in the unit of R, G, B: under a light of constant spectrum 1 each is
/// 1 where R, G, B make a Y of 1. All wavelengths of the film are drawn from that range, evenly; so
/// R, G and B miss what lies outside.
class SpectralBuckets {
  public:
    static constexpr std::string_view kName = "spectral";
    static SpectralBuckets Create(ParamDict &params);

    /// Of one pixel, by bucket.
    struct Sums {
        std::vector<double> values, weights;
    };
    Sums NewSums() const { return {std::vector<double>(n), std::vector<double>(n)}; }
    SampledWavelengths SampleWavelengths(float u) const {
        return SampledWavelengths::SampleUniform(u, lambdaMin, lambdaMax);
    }
    /// Counts the sample's wavelengths where they lie; ended ones (pdf 0) nowhere.
    void Add(Sums *sums, SampledSpectrum L, const SampledWavelengths &lambda, float weight) const;

    /// `S0.<middle of the bucket, decimal comma>nm`, as in the layout of spectral OpenEXR files by
    /// Fichet et al. 2021.
    std::vector<std::string> ChannelNames() const;
    /// One value per channel; 0 where a bucket got no sample.
    void Write(const Sums &sums, float *channels) const;
    int BucketOf(float lambda) const {
        return std::clamp(int((lambda - lambdaMin) / (lambdaMax - lambdaMin) * float(n)), 0,
                          int(n) - 1);
    }

  private:
    size_t n = 16;
    float lambdaMin = LambdaMin, lambdaMax = LambdaMax;
};

}  // namespace pbrt
