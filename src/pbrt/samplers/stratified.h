#pragma once

#include <algorithm>

#include "pbrt/samplers/dimension_block.h"
#include "pbrt/samplers/permutation.h"
#include "pbrt/samplers/sampler.h"
#include "pbrt/util/hash.h"

namespace pbrt {

/// Pairs: one sample in each of xSamples x ySamples cells per pixel; single numbers: one in each of
/// as many intervals. Which cell comes when is a random permutation per pixel and dimension.
class StratifiedSampler {
  public:
    static constexpr std::string_view kName = "stratified";

    /// Without jitter samples lie in the cells' middles. Counts from 1 to 2^10.
    explicit StratifiedSampler(int xSamples = 4, int ySamples = 4, bool jitter = true, int seed = 0)
        : order(uint32_t(xSamples * ySamples)),
          xSamples(float(xSamples)),
          ySamples(float(ySamples)),
          spread(jitter ? 1 : 0),
          middle(jitter ? 0 : 0.5f),
          seed(seed) {}

    static StratifiedSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return int(order.Size()); }
    /// `dimension` counts draws of either kind; 0 <= sampleIndex < SamplesPerPixel().
    void StartPixelSample(Point2i p, int sampleIndex, int dimension = 0) {
        DCHECK(sampleIndex < SamplesPerPixel());
        index = uint32_t(sampleIndex);
        pixelBits = Hash(seed, p);
        sampleBits = Mix64(pixelBits + kGolden64 * (index + 1));
        block.StartAt(dimension);
    }
    float Get1D() { return single[NextLane()]; }
    Point2f Get2D() {
        const int lane = NextLane();
        return {x[lane], y[lane]};
    }
    Point2f GetPixel2D() { return Get2D(); }

  private:
    static constexpr int kLanes = DimensionBlock::kSize;
    using Lanes = uint32_t[kLanes];

    int NextLane() {
        return block.Next([this](int first) { FillNumbers(uint32_t(first)); });
    }
    void FillCells(uint32_t first, Lanes &cell) const;
    void FillNumbers(uint32_t first);

    Permutation order;
    float xSamples, ySamples;
    float spread, middle;  ///< place in a cell: middle + spread * random
    int seed;
    uint32_t index = 0;
    uint64_t pixelBits = 0, sampleBits = 0;
    DimensionBlock block;
    float single[kLanes] = {}, x[kLanes] = {}, y[kLanes] = {};
};

inline void StratifiedSampler::FillCells(uint32_t first, Lanes &cell) const {
    Lanes walkKey;
    for (int i = 0; i < kLanes; ++i) {
        walkKey[i] = Mix32((first + uint32_t(i)) * 0x9e3779b9 + uint32_t(pixelBits));
        cell[i] = order.Walk(index, walkKey[i]);
    }
    uint32_t outside;
    do {
        outside = 0;
        for (int i = 0; i < kLanes; ++i) {
            const uint32_t further = order.Walk(cell[i], walkKey[i]);
            cell[i] = order.Inside(cell[i]) ? cell[i] : further;
            outside |= uint32_t(!order.Inside(cell[i]));
        }
    } while (outside);
    for (int i = 0; i < kLanes; ++i) {
        const uint32_t dimension = first + uint32_t(i);
        cell[i] = order.Rotate(cell[i], Mix32(dimension * 0x9e3779b9 + uint32_t(pixelBits >> 32)));
    }
}

inline void StratifiedSampler::FillNumbers(uint32_t first) {
    Lanes cell;
    FillCells(first, cell);
    const float width = 1 / xSamples, height = 1 / ySamples;
    for (int i = 0; i < kLanes; ++i) {
        const uint32_t step = (first + uint32_t(i)) * 0x9e3779b9;
        const float inX = middle + spread * ToUnitFloat(Mix32(step + uint32_t(sampleBits)));
        const float inY = middle + spread * ToUnitFloat(Mix32(step + uint32_t(sampleBits >> 32)));
        const float place = float(int32_t(cell[i]));
        // Half a cell away from the integers rounding does not matter up to 2^20 cells.
        const float row = float(int32_t((place + 0.5f) * width));
        single[i] = std::min((place + inX) * (width * height), OneMinusEpsilon);
        x[i] = std::min((place - row * xSamples + inX) * width, OneMinusEpsilon);
        y[i] = std::min((row + inY) * height, OneMinusEpsilon);
    }
}

}  // namespace pbrt
