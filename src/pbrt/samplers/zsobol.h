#pragma once

#include <array>
#include <bit>

#include "pbrt/samplers/dimension_block.h"
#include "pbrt/samplers/permutation.h"
#include "pbrt/samplers/sampler.h"
#include "pbrt/samplers/sobol.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// What is done to the digits of the Sobol' points, with keys that depend on seed and dimension.
enum class Randomization { None, PermuteDigits, Owen, FastOwen };

/// Screen-space blue noise by one (0,2)-sequence along a randomised Z-order curve of pixels (Ahmed
/// and Wonka 2020, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via
/// Hierarchical Ordering of Pixels"). In each dimension the four children of every node of the
/// pixel quadtree come in a random order; the samples of a pixel follow one another. So the samples
/// of each pixel, and of each square of 4^k aligned pixels, are a (0,m,2)-net. Their order within
/// the pixel is a random permutation rather than a hierarchical one: that would make the samples of
/// two dimensions depend on each other (see BitPermutation), and buys only that the first few
/// samples of a pixel are a net too.
///
/// Numbers are made for sixteen dimensions at a time (the loops vectorise); what depends on the
/// pixel and not on the index is kept, so a pixel's samples should be taken one after another.
class ZSobolSampler {
  public:
    static constexpr std::string_view kName = "zsobol";

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
        return {x[lane], y[lane]};
    }
    Point2f GetPixel2D() { return Get2D(); }

  private:
    static constexpr int kLanes = DimensionBlock::kSize, kKnownBlocks = 4;
    using Lanes = uint32_t[kLanes];

    /// What sixteen successive dimensions need to know about the pixel.
    struct PixelBlock {
        Lanes firstPoint;  ///< place of the pixel's samples in the sequence, modulo 2^32
        Lanes carry;       ///< that place divided by 2^32
        Lanes order;       ///< key of the order of the samples
        Lanes keyX, keyY;
    };

    void FillPixelBlock(int first, PixelBlock &b) const;
    void FillNumbers(int first);
    template <typename Scramble>
    void FillNumbers(const PixelBlock &b, Scramble scramble);

    int log2Samples, levels;
    Randomization randomization;
    uint32_t seedBits;
    uint32_t morton = 0;       ///< of the current pixel
    uint32_t knownBlocks = 0;  ///< bit k: pixelBlocks[k] holds for the current pixel
    uint32_t index = 0;        ///< of the current sample
    DimensionBlock block;
    float x[kLanes] = {}, y[kLanes] = {};
    std::array<PixelBlock, kKnownBlocks> pixelBlocks{};
};

inline void ZSobolSampler::FillPixelBlock(int first, PixelBlock &b) const {
    Lanes keys, pixelIndex = {};
    for (int i = 0; i < kLanes; ++i) {
        const uint32_t dimension = uint32_t(first + i);
        keys[i] = Mix32(dimension * 0x9e3779b9 + seedBits);
        b.keyX[i] = Mix32(keys[i] + 1);
        b.keyY[i] = Mix32(keys[i] + 2);
        b.order[i] = Mix32(Mix32(morton + 3) ^ keys[i]);
    }
    for (int level = levels - 1; level >= 0; --level) {
        // A node of the quadtree: the digits above this one, and a bit that tells how many.
        const uint32_t depthBit = uint32_t(1) << (2 * (levels - 1 - level));
        const uint32_t node = Mix32((uint32_t(uint64_t(morton) >> (2 * level + 2))) | depthBit);
        const uint32_t digit = morton >> (2 * level);
        const uint32_t low = -(digit & 1), high = -((digit >> 1) & 1);
        for (int i = 0; i < kLanes; ++i) {
            // Each permutation of four things is an affine map of GF(2)^2: two different columns
            // other than 0, and a constant.
            const uint32_t h = Mix32(node ^ keys[i]);
            const uint32_t a = 1 + (((h >> 16) * 3) >> 16);
            const uint32_t further = a + 1 + ((h >> 2) & 1);
            const uint32_t c = further > 3 ? further - 3 : further;
            pixelIndex[i] = (pixelIndex[i] << 2) | ((h & 3) ^ (a & low) ^ (c & high));
        }
    }
    for (int i = 0; i < kLanes; ++i) {
        b.firstPoint[i] = pixelIndex[i] << log2Samples;
        b.carry[i] = uint32_t(uint64_t(pixelIndex[i]) >> (32 - log2Samples));
    }
}

template <typename Scramble>
void ZSobolSampler::FillNumbers(const PixelBlock &b, Scramble scramble) {
    const BitPermutation order(log2Samples);
    for (int i = 0; i < kLanes; ++i) {
        const uint32_t point = b.firstPoint[i] | order(index, b.order[i]);
        // The sixth step of the butterfly folds the point's upper 32 bits onto the lower.
        x[i] = ToUnitFloat(ReverseBits32(scramble(point, b.keyX[i])));
        y[i] = ToUnitFloat(ReverseBits32(scramble(SobolYReversed(point ^ b.carry[i]), b.keyY[i])));
    }
}

inline void ZSobolSampler::FillNumbers(int first) {
    const int which = first / kLanes;
    PixelBlock local;
    const bool keep = which < kKnownBlocks;
    PixelBlock &b = keep ? pixelBlocks[size_t(which)] : local;
    if (!keep || !(knownBlocks >> which & 1)) {
        FillPixelBlock(first, b);
        if (keep) knownBlocks |= uint32_t(1) << which;
    }
    switch (randomization) {
        case Randomization::None:
            return FillNumbers(b, [](uint32_t v, uint32_t) { return v; });
        case Randomization::PermuteDigits:
            return FillNumbers(b, [](uint32_t v, uint32_t key) { return v ^ key; });
        case Randomization::Owen:
            return FillNumbers(b, [](uint32_t v, uint32_t key) { return OwenReversed(v, key); });
        case Randomization::FastOwen:
            // A lambda, not the function's address: only so is it inlined and vectorised.
            return FillNumbers(b,
                               [](uint32_t v, uint32_t key) { return FastOwenReversed(v, key); });
    }
}

}  // namespace pbrt
