#pragma once

#include <array>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/pixel_table.h"

namespace pbrt {

/// Every number on its own: hashes of (seed, pixel, sample index, dimension).
class IndependentSampler {
  public:
    static constexpr std::string_view kName = "independent";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"integer pixelsamples\" 16"};

    explicit IndependentSampler(int samplesPerPixel = 4, int seed = 0)
        : samplesPerPixel(samplesPerPixel), seed(seed) {}

    static IndependentSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return samplesPerPixel; }
    /// `dimension` counts draws of either kind.
    void StartPixelSample(Point2i pixel, int sampleIndex, int dimension = 0) {
        state = Hash(seed, pixel, sampleIndex) + uint64_t(dimension) * kGolden64;
    }
    float Get1D() { return Get2D().x; }
    Point2f Get2D() {
        const uint64_t bits = Mix64(state += kGolden64);
        return {ToUnitFloat(uint32_t(bits >> 32)), ToUnitFloat(uint32_t(bits))};
    }

    void StartBatch(std::span<const Point2i> pixels) { batch.Start(pixels, seed); }
    FloatX16 Get1D(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        return Get2D(dimension, pixel, sampleIndex).x;
    }
    Point2fX16 Get2D(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        // As Hash goes on.
        const Uint64X16 start =
            Mix64((batch.At(pixel) + kGolden64) ^ Convert<uint64_t>(sampleIndex));
        const Uint64X16 bits = Mix64(start + (uint64_t(dimension) + 1) * kGolden64);
        return {ToUnitFloat(HighHalf(bits)), ToUnitFloat(LowHalf(bits))};
    }

  private:
    int samplesPerPixel, seed;
    uint64_t state = 0;
    PixelHashes batch;
};
static_assert(SamplerType<IndependentSampler>);

}  // namespace pbrt
