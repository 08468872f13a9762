#pragma once

#include <array>
#include <bit>
#include <span>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/dimension_block.h"
#include "pbrt/samplers/permutation.h"
#include "pbrt/samplers/pixel_table.h"
#include "pbrt/samplers/randomization.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// Screen-space blue noise by one (0,2)-sequence along a randomised Z-order curve of pixels (Ahmed
/// and Wonka 2020, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via
/// Hierarchical Ordering of Pixels"). In each dimension the four children of every node of the
/// pixel quadtree come in a random order; the samples of a pixel follow one another. So the samples
/// of each pixel, and of each square of 4^k aligned pixels, are a (0,m,2)-net. Their order within
/// the pixel is a random permutation rather than a hierarchical one: that would make the samples of
/// two dimensions depend on each other (see BitPermutation), and buys only that the first few
/// samples of a pixel are a net too.
///
/// Numbers are made sixteen at a time: as many dimensions of one sample, or as many samples of a
/// batch in one dimension. What depends on the pixel and not on the index is kept: of one pixel for
/// the first 64 dimensions, so its samples should be taken one after another; of a batch for the
/// last 64 dimensions asked for.
class ZSobolSampler {
  public:
    static constexpr std::string_view kName = "zsobol";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 4> kExamples{
        "", "\"string randomization\" \"owen\" \"integer pixelsamples\" 32",
        "\"string randomization\" \"permutedigits\"", "\"integer pixelsamples\" 1"};

    /// samplesPerPixel: a power of two up to 2^24; resolution up to 2^16 on each side.
    explicit ZSobolSampler(int samplesPerPixel = 16, Point2i fullResolution = {1, 1},
                           Randomization randomization = Randomization::FastOwen, int seed = 0)
        : log2Samples(std::bit_width(uint32_t(samplesPerPixel)) - 1),
          levels(
              std::bit_width(uint32_t(std::max({fullResolution.x - 1, fullResolution.y - 1, 0})))),
          randomization(randomization),
          seedBits(uint32_t(Hash(seed, 1))) {
        DCHECK(std::has_single_bit(uint32_t(samplesPerPixel)) && levels <= 16);
    }

    static ZSobolSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return 1 << log2Samples; }
    /// `dimension` counts draws of either kind; 0 <= sampleIndex < SamplesPerPixel().
    void StartPixelSample(Point2i p, int sampleIndex, int dimension = 0) {
        DCHECK(sampleIndex < SamplesPerPixel());
        const uint32_t code = EncodeMorton2(uint32_t(p.x), uint32_t(p.y));
        if (code != morton) {
            morton = code;
            knownBlocks = 0;
        }
        index = uint32_t(sampleIndex);
        block.StartAt(dimension);
    }
    float Get1D() { return Get2D().x; }
    Point2f Get2D() {
        const int lane = block.Next([this](int first) { FillNumbers(first); });
        return {numbers.x[lane], numbers.y[lane]};
    }

    void StartBatch(std::span<const Point2i> pixels);
    FloatX16 Get1D(int dimension, UintX16 pixel, UintX16 sampleIndex) {
        return Get2D(dimension, pixel, sampleIndex).x;
    }
    Point2fX16 Get2D(int dimension, UintX16 pixel, UintX16 sampleIndex) {
        const BatchDimension &t = InBatch(dimension);
        return Numbers({t.firstPoint.At(pixel), t.carry.At(pixel), t.order.At(pixel)}, t.keys,
                       sampleIndex);
    }

  private:
    static constexpr int kKnownBlocks = 4, kKnownDimensions = 64;

    /// Data of a pixel in one dimension, sixteen times.
    struct PixelPlace {
        UintX16 firstPoint;  ///< place of the pixel's samples in the sequence, modulo 2^32
        UintX16 carry;       ///< that place divided by 2^32
        UintX16 order;       ///< key of the order of the samples
    };
    struct DimensionKeys {
        UintX16 order, x, y;
    };
    struct PixelBlock {
        PixelPlace place;
        DimensionKeys keys;
    };
    struct BatchDimension {
        int dimension = -1;
        DimensionKeys keys;
        PixelTable firstPoint, carry, order;
    };

    DimensionKeys KeysOf(UintX16 dimension) const;
    PixelPlace PlaceOf(UintX16 mortonCode, const DimensionKeys &keys) const;
    Point2fX16 Numbers(const PixelPlace &place, const DimensionKeys &keys,
                       UintX16 sampleIndex) const;
    template <typename Scramble>
    Point2fX16 Numbers(const PixelPlace &place, const DimensionKeys &keys, UintX16 sampleIndex,
                       Scramble scramble) const;
    void FillNumbers(int first);
    const BatchDimension &InBatch(int dimension) {
        BatchDimension &t = batch[size_t(dimension % kKnownDimensions)];
        if (t.dimension != dimension) [[unlikely]]
            FillBatchDimension(dimension, t);
        return t;
    }
    void FillBatchDimension(int dimension, BatchDimension &t) const;

    int log2Samples, levels;
    Randomization randomization;
    uint32_t seedBits;
    uint32_t morton = 0;       ///< of the current pixel
    uint32_t knownBlocks = 0;  ///< bit k: pixelBlocks[k] holds for the current pixel
    uint32_t index = 0;        ///< of the current sample
    DimensionBlock block;
    Point2fX16 numbers;
    std::array<PixelBlock, kKnownBlocks> pixelBlocks{};
    PixelTable batchMorton;
    std::array<BatchDimension, kKnownDimensions> batch;  ///< [dimension % size]
};
static_assert(SamplerType<ZSobolSampler>);

inline ZSobolSampler::DimensionKeys ZSobolSampler::KeysOf(UintX16 dimension) const {
    const UintX16 key = Mix32(dimension * 0x9e3779b9 + seedBits);
    return {key, Mix32(key + 1), Mix32(key + 2)};
}

inline ZSobolSampler::PixelPlace ZSobolSampler::PlaceOf(UintX16 mortonCode,
                                                        const DimensionKeys &keys) const {
    UintX16 pixelIndex{};
    for (int level = levels - 1; level >= 0; --level) {
        // A node of the quadtree: the digits above this one, and a bit that tells how many.
        const uint32_t depthBit = uint32_t(1) << (2 * (levels - 1 - level));
        const UintX16 node = Mix32((mortonCode >> (2 * level + 1) >> 1) | depthBit);
        const UintX16 digit = mortonCode >> (2 * level);
        const UintX16 low = -(digit & 1), high = -((digit >> 1) & 1);
        // Each permutation of four things is an affine map of GF(2)^2: two different columns
        // other than 0, and a constant.
        const UintX16 h = Mix32(node ^ keys.order);
        const UintX16 a = 1 + (((h >> 16) * 3) >> 16);
        const UintX16 further = a + 1 + ((h >> 2) & 1);
        const UintX16 c = Select(further > 3, further - 3, further);
        pixelIndex = (pixelIndex << 2) | ((h & 3) ^ (a & low) ^ (c & high));
    }
    return {pixelIndex << log2Samples,
            log2Samples == 0 ? UintX16{} : pixelIndex >> (32 - log2Samples),
            Mix32(Mix32(mortonCode + 3) ^ keys.order)};
}

template <typename Scramble>
Point2fX16 ZSobolSampler::Numbers(const PixelPlace &place, const DimensionKeys &keys,
                                  UintX16 sampleIndex, Scramble scramble) const {
    const UintX16 point = place.firstPoint | BitPermutation(log2Samples)(sampleIndex, place.order);
    // The sixth step of the butterfly folds the point's upper 32 bits onto the lower.
    return PairOfReversed(scramble(point, keys.x),
                          scramble(SobolYReversed(point ^ place.carry), keys.y));
}

inline Point2fX16 ZSobolSampler::Numbers(const PixelPlace &place, const DimensionKeys &keys,
                                         UintX16 sampleIndex) const {
    return WithScramble(randomization,
                        [&](auto scramble) { return Numbers(place, keys, sampleIndex, scramble); });
}

inline void ZSobolSampler::FillNumbers(int first) {
    const int which = first / kPacketSize;
    PixelBlock local;
    const bool keep = which < kKnownBlocks;
    PixelBlock &b = keep ? pixelBlocks[size_t(which)] : local;
    if (!keep || !(knownBlocks >> which & 1)) {
        b.keys = KeysOf(uint32_t(first) + kLaneNumbers);
        b.place = PlaceOf(Broadcast<16>(morton), b.keys);
        if (keep) knownBlocks |= uint32_t(1) << which;
    }
    numbers = Numbers(b.place, b.keys, Broadcast<16>(index));
}

inline void ZSobolSampler::StartBatch(std::span<const Point2i> pixels) {
    batchMorton.Resize(pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i)
        batchMorton[i] = EncodeMorton2(uint32_t(pixels[i].x), uint32_t(pixels[i].y));
    for (BatchDimension &t : batch)
        t.dimension = -1;
}

inline void ZSobolSampler::FillBatchDimension(int dimension, BatchDimension &t) const {
    t.dimension = dimension;
    t.keys = KeysOf(Broadcast<16>(uint32_t(dimension)));
    for (PixelTable *table : {&t.firstPoint, &t.carry, &t.order})
        table->Resize(batchMorton.Size());
    for (size_t i = 0; i < batchMorton.Size(); i += kPacketSize) {
        const PixelPlace place = PlaceOf(batchMorton.From(i), t.keys);
        t.firstPoint.SetFrom(i, place.firstPoint);
        t.carry.SetFrom(i, place.carry);
        t.order.SetFrom(i, place.order);
    }
}

}  // namespace pbrt
