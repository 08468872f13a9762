#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "pbrt/base/sampler.h"

namespace pbrt {

/// SamplerTraits::hasBatches of a sampler that has them not: sixteen draws one by one.
template <SamplerType S>
class OneByOneSampler {
  public:
    OneByOneSampler(const S &sampler) : sampler(sampler) {}

    int SamplesPerPixel() const { return sampler.SamplesPerPixel(); }
    void StartBatch(std::span<const Point2i> batch) { pixels.assign(batch.begin(), batch.end()); }
    FloatX16 Get1D(int dimension, const UintX16 &pixel, const UintX16 &index) {
        FloatX16 numbers;
        for (int i = 0; i < kPacketSize; ++i) {
            Start(dimension, pixel[i], index[i]);
            numbers.Set(i, sampler.Get1D());
        }
        return numbers;
    }
    Point2fX16 Get2D(int dimension, const UintX16 &pixel, const UintX16 &index) {
        Point2fX16 numbers;
        for (int i = 0; i < kPacketSize; ++i) {
            Start(dimension, pixel[i], index[i]);
            SetLane(&numbers, i, sampler.Get2D());
        }
        return numbers;
    }

  private:
    void Start(int dimension, uint32_t pixel, uint32_t index) {
        const auto last = uint32_t(sampler.SamplesPerPixel()) - 1;
        sampler.StartPixelSample(pixels[pixel], int(std::min(index, last)), dimension);
    }
    S sampler;
    std::vector<Point2i> pixels;
};

/// The sampler with batches: itself, or one by one.
template <SamplerType S>
using BatchSampler = std::conditional_t<S::kTraits.hasBatches, S, OneByOneSampler<S>>;

}  // namespace pbrt
