#pragma once

#include <array>
#include <span>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/dimension_block.h"
#include "pbrt/samplers/permutation.h"
#include "pbrt/samplers/pixel_table.h"
#include "pbrt/util/hash.h"

namespace pbrt {

/// Pairs: one sample in each of xSamples x ySamples cells per pixel; single numbers: one in each of
/// as many intervals. Which cell comes when is a random permutation per pixel and dimension.
class StratifiedSampler {
  public:
    static constexpr std::string_view kName = "stratified";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"integer xsamples\" 5 \"integer ysamples\" 3",
        "\"integer xsamples\" 1 \"integer ysamples\" 1"};

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
        block.StartAt(dimension);
    }
    float Get1D() { return numbers.single[NextLane()]; }
    Point2f Get2D() {
        const int lane = NextLane();
        return {numbers.x[lane], numbers.y[lane]};
    }

    void StartBatch(std::span<const Point2i> pixels) { batch.Start(pixels, seed); }
    FloatX16 Get1D(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        return InBatch(dimension, pixel, sampleIndex).single;
    }
    Point2fX16 Get2D(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        const Numbers n = InBatch(dimension, pixel, sampleIndex);
        return {n.x, n.y};
    }

  private:
    struct Numbers {
        FloatX16 single, x, y;
    };

    int NextLane() {
        return block.Next([this](int first) {
            numbers = NumbersOf(uint32_t(first) + kLaneNumbers, Uint64X16{} + pixelBits,
                                Broadcast<16>(index));
        });
    }
    Numbers InBatch(int dimension, UintX16 pixel, UintX16 sampleIndex) const {
        return NumbersOf(Broadcast<16>(uint32_t(dimension)), batch.At(pixel),
                         Select(sampleIndex < order.Size(), sampleIndex, UintX16{}));
    }
    Numbers NumbersOf(UintX16 dimension, const Uint64X16 &hashes, UintX16 sampleIndex) const;

    Permutation order;
    float xSamples, ySamples;
    float spread, middle;  ///< place in a cell: middle + spread * random
    int seed;
    uint32_t index = 0;
    uint64_t pixelBits = 0;
    DimensionBlock block;
    Numbers numbers{};
    PixelHashes batch;
};
static_assert(SamplerType<StratifiedSampler>);

inline StratifiedSampler::Numbers StratifiedSampler::NumbersOf(UintX16 dimension,
                                                               const Uint64X16 &hashes,
                                                               UintX16 sampleIndex) const {
    const UintX16 step = dimension * 0x9e3779b9;
    const UintX16 cell =
        order(sampleIndex, Mix32(step + LowHalf(hashes)), Mix32(step + HighHalf(hashes)));
    const Uint64X16 sampleBits = Mix64(hashes + kGolden64 * Convert<uint64_t>(sampleIndex + 1));
    const FloatX16 inX = middle + spread * ToUnitFloat(Mix32(step + LowHalf(sampleBits)));
    const FloatX16 inY = middle + spread * ToUnitFloat(Mix32(step + HighHalf(sampleBits)));
    const float width = 1 / xSamples, height = 1 / ySamples;
    const FloatX16 place = ToFloat(cell);
    // Half a cell away from the integers rounding does not matter up to 2^20 cells.
    const FloatX16 row = Floor((place + 0.5f) * width);
    return {Min((place + inX) * (width * height), OneMinusEpsilon),
            Min((place - row * xSamples + inX) * width, OneMinusEpsilon),
            Min((row + inY) * height, OneMinusEpsilon)};
}

}  // namespace pbrt
