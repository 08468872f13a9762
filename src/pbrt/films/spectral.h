#pragma once

#include <algorithm>

#include "pbrt/base/film.h"
#include "pbrt/films/exact_sum.h"

namespace pbrt {

/// Film `spectral`: mean radiance in `nbuckets` equal parts of [lambdamin, lambdamax] nm, in the
/// unit of R, G, B: under a light of constant spectrum 1 each is 1 where R, G, B make a Y of 1. All
/// wavelengths of the film are drawn from that range, evenly; so R, G and B miss what lies outside.
class SpectralFilm {
  public:
    static constexpr std::string_view kName = "spectral";
    static constexpr FilmTraits kTraits{.spectral = true, .exrOnly = true};
    /// Sums by bucket.
    struct Sums {
        std::vector<ExactSum> values, weights;

        template <typename F>
        void ForEach(const F &f) {
            for (ExactSum &s : values)
                f(s);
            for (ExactSum &s : weights)
                f(s);
        }
    };

    static SpectralFilm Create(ParamDict &params);
    void SetSpaces(const Transform &, const Transform &) {}
    SampledWavelengths SampleWavelengths(float u) const {
        return SampledWavelengths::SampleUniform(u, lambdaMin, lambdaMax);
    }
    Sums NewSums() const { return {std::vector<ExactSum>(n), std::vector<ExactSum>(n)}; }
    /// Counts the sample's wavelengths where they lie; ended ones (pdf 0) nowhere.
    void Add(Sums *sums, const FilmSample &sample) const;
    /// `S0.<middle of the bucket, decimal comma>nm`, as in the layout of spectral OpenEXR files by
    /// Fichet et al. 2021.
    std::vector<std::string> ChannelNames() const;
    /// 0 where a bucket got no sample.
    void Write(const Sums &sums, float *channels) const;
    void WriteMetadata(std::map<std::string, std::string> *strings) const;
    int BucketOf(float lambda) const {
        return std::clamp(int((lambda - lambdaMin) / (lambdaMax - lambdaMin) * float(n)), 0,
                          int(n) - 1);
    }

  private:
    size_t n = 16;
    float lambdaMin = LambdaMin, lambdaMax = LambdaMax;
};

}  // namespace pbrt
