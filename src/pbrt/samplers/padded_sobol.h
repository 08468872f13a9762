#pragma once

#include <array>
#include <span>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/permutation.h"
#include "pbrt/samplers/pixel_table.h"
#include "pbrt/samplers/randomization.h"
#include "pbrt/samplers/sampler_params.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// The first points of the (0,2)-sequence of Sobol' in each pixel and each dimension, randomised
/// anew and in a random order: pairs of one draw are a (0,m,2)-net where their number is a power of
/// two, and independent of those of other draws and pixels ("padding").
class PaddedSobolSampler {
  public:
    static constexpr std::string_view kName = "paddedsobol";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"string randomization\" \"owen\" \"integer pixelsamples\" 32",
        "\"string randomization\" \"permutedigits\""};

    /// samplesPerPixel: up to 2^24.
    explicit PaddedSobolSampler(int samplesPerPixel = 16,
                                Randomization randomization = Randomization::FastOwen, int seed = 0)
        : order(uint32_t(samplesPerPixel)), randomization(randomization), seed(seed) {}

    static PaddedSobolSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return int(order.Size()); }
    /// `dimension` counts draws of either kind; 0 <= sampleIndex < SamplesPerPixel().
    void StartPixelSample(Point2i p, int sampleIndex, int dimension = 0) {
        DCHECK(sampleIndex < SamplesPerPixel());
        index = uint32_t(sampleIndex);
        pixelBits = Hash(seed, p);
        next = dimension;
    }
    float Get1D() { return Get2D().x; }
    Point2f Get2D() {
        return Numbers(next++, uint32_t(pixelBits), uint32_t(pixelBits >> 32), index);
    }

    void StartBatch(std::span<const Point2i> pixels) { batch.Start(pixels, seed); }
    FloatX16 Get1D(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        return Get2D(dimension, pixel, sampleIndex).x;
    }
    Point2fX16 Get2D(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        const Uint64X16 bits = batch.At(pixel);
        return Numbers(dimension, LowHalf(bits), HighHalf(bits),
                       Select(sampleIndex < order.Size(), sampleIndex, UintX16{}));
    }

  private:
    /// The draw of sample k in a pixel with these 64 random bits.
    template <typename U>
    Vec2<UnitFloat<U>> Numbers(int dimension, const U &low, const U &high, const U &k) const {
        const uint32_t step = uint32_t(dimension) * 0x9e3779b9;
        const U a = Mix32(low + step), b = Mix32(high + step);
        const U point = order(k, a, b);
        return WithScramble(randomization, [&](auto scramble) {
            return PairOfReversed(scramble(point, Mix32(a + 1)),
                                  scramble(SobolYReversed(point), Mix32(b + 1)));
        });
    }

    Permutation order;
    Randomization randomization;
    int seed;
    int next = 0;  ///< dimension
    uint32_t index = 0;
    uint64_t pixelBits = 0;
    PixelHashes batch;
};
static_assert(SamplerType<PaddedSobolSampler>);

inline PaddedSobolSampler PaddedSobolSampler::Create(ParamDict &params,
                                                     const SamplerContext &context) {
    const int samples = ReadSamples(params, 16, context);
    AdvisePowerOfTwo(params, samples, kName);
    const auto randomization = Randomization(params.GetOneChoice(kRandomization));
    return PaddedSobolSampler(samples, randomization, ReadSeed(params, context));
}

}  // namespace pbrt
