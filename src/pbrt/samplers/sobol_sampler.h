#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/padded_sobol.h"
#include "pbrt/samplers/pixel_table.h"
#include "pbrt/samplers/randomization.h"
#include "pbrt/samplers/sampler_params.h"
#include "pbrt/samplers/sobol_matrices.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// One Sobol' sequence over the whole image: its first two dimensions are the place in a square of
/// 2^m pixels a side, which holds the image. Each run of 4^m points has one in each pixel, so
/// sample k of a pixel is one of run k; which one follows from the pixel (Gruenschlos, Raab and
/// Keller 2012, "Enumerating Quasi-Monte Carlo Point Sequences in Elementary Intervals"). The draw
/// of the film takes the digits of both coordinates after the first m, which choose the pixel,
/// randomised anew in each column and each row; each other draw takes the next two dimensions.
/// Draws beyond the 256 dimensions are those of `paddedsobol`.
class SobolSampler {
  public:
    static constexpr std::string_view kName = "sobol";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 4> kExamples{
        "", "\"string randomization\" \"owen\" \"integer pixelsamples\" 32",
        "\"string randomization\" \"permutedigits\"", "\"integer pixelsamples\" 1"};

    /// samplesPerPixel: up to 2^24; resolution up to 2^16 on each side.
    explicit SobolSampler(int samplesPerPixel = 16, Point2i fullResolution = {1, 1},
                          Randomization randomization = Randomization::FastOwen, int seed = 0)
        : samplesPerPixel(samplesPerPixel),
          m(std::bit_width(uint32_t(std::max({fullResolution.x - 1, fullResolution.y - 1, 0})))),
          randomization(randomization),
          seedBits(uint32_t(Hash(seed, 4))),
          matrices(&SobolMatrices::Get()),
          padded(samplesPerPixel, randomization, seed) {
        DCHECK(samplesPerPixel >= 1 && m <= 16);
    }

    static SobolSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return samplesPerPixel; }
    /// `dimension` counts draws of either kind; 0 <= sampleIndex < SamplesPerPixel().
    void StartPixelSample(Point2i p, int sampleIndex, int dimension = 0) {
        DCHECK(sampleIndex < SamplesPerPixel());
        pixel = p;
        sample = sampleIndex;
        index = IndexOf(FirstIndex(p), uint32_t(sampleIndex));
        next = dimension;
    }
    float Get1D() { return Get2D().x; }
    Point2f Get2D() {
        const int dimension = next++;
        if (dimension < kDraws) return Pair(dimension, index);
        padded.StartPixelSample(pixel, sample, dimension);
        return padded.Get2D();
    }

    void StartBatch(std::span<const Point2i> pixels) {
        firstIndices.Fill(pixels, [&](Point2i p) { return FirstIndex(p); });
        padded.StartBatch(pixels);
    }
    FloatX16 Get1D(int dimension, UintX16 place, UintX16 sampleIndex) const {
        return Get2D(dimension, place, sampleIndex).x;
    }
    Point2fX16 Get2D(int dimension, UintX16 place, UintX16 sampleIndex) const {
        if (dimension >= kDraws) return padded.Get2D(dimension, place, sampleIndex);
        return Pair(dimension, IndexOf(firstIndices.At(place), sampleIndex));
    }

  private:
    static constexpr int kDraws = kSobolDimensions / 2;

    /// An index in the sequence: low + 2^32 high.
    template <typename U>
    struct Index {
        U low, high;
    };

    uint32_t FirstDigits() const { return (uint32_t(1) << m) - 1; }
    /// Digits m to 2m - 1 of the index, given what they must add to the first m digits of the
    /// second coordinate (reversed).
    template <typename U>
    U MiddleDigits(U wanted) const;
    /// Index of the pixel's first sample.
    uint32_t FirstIndex(Point2i p) const;
    template <typename U>
    Index<U> IndexOf(const U &firstIndex, const U &k) const;
    template <typename U>
    Vec2<UnitFloat<U>> Pair(int dimension, const Index<U> &i) const;
    template <typename U>
    Vec2<UnitFloat<U>> FilmPair(const Index<U> &i, uint32_t xKey, uint32_t yKey) const;

    int samplesPerPixel, m;
    Randomization randomization;
    uint32_t seedBits;
    const SobolMatrices *matrices;
    PaddedSobolSampler padded;
    Point2i pixel;
    int sample = 0, next = 0;
    Index<uint32_t> index{};
    PixelTable firstIndices;
};
static_assert(SamplerType<SobolSampler>);

// Digit r of the second coordinate is the sum over the index digits s of (s over r) modulo 2
// (sobol.h). For digits m + s, by Vandermonde, that is the sum over t of (m over r - t) (s over t):
// the same butterfly on them, and then a product with the polynomial (1 + z)^m. Both are inverted
// easily: the butterfly is its own inverse, and modulo 2 and z^m, (1 + z)^(2^l) is 1 for 2^l >= m.
template <typename U>
U SobolSampler::MiddleDigits(U wanted) const {
    const uint32_t inverse = std::bit_ceil(uint32_t(m)) - uint32_t(m);
    for (int l = 0; inverse >> l != 0; ++l)
        if (inverse >> l & 1) wanted ^= wanted << (1 << l);
    return SobolYReversed(U(wanted & FirstDigits())) & FirstDigits();
}

inline uint32_t SobolSampler::FirstIndex(Point2i p) const {
    const auto reversed = [&](int i) {
        return uint32_t(uint64_t(ReverseBits32(uint32_t(i))) << m >> 32);
    };
    const uint32_t x = reversed(p.x);
    return x | (MiddleDigits(reversed(p.y) ^ SobolYReversed(x)) << m);
}

template <typename U>
SobolSampler::Index<U> SobolSampler::IndexOf(const U &firstIndex, const U &k) const {
    // m = 0 and m = 16 would shift by 32.
    const U low = m == 16 ? U{} : k << (2 * m), high = m == 0 ? U{} : k >> (32 - 2 * m);
    const U middle = MiddleDigits(SobolYReversed(U(low ^ high)));
    return {firstIndex ^ low ^ (middle << m), high};
}

template <typename U>
Vec2<UnitFloat<U>> SobolSampler::Pair(int dimension, const Index<U> &i) const {
    const uint32_t key = Mix32(uint32_t(dimension) * 0x9e3779b9 + seedBits);
    const uint32_t xKey = Mix32(key + 1), yKey = Mix32(key + 2);
    if (dimension == kFilmDimension) return FilmPair(i, xKey, yKey);
    const int first = 2 * (dimension + (dimension < kFilmDimension ? 1 : 0));
    const int bits = 2 * m + std::bit_width(uint32_t(samplesPerPixel - 1));
    const U x = matrices->Number(first, i.low, i.high, bits);
    const U y = matrices->Number(first + 1, i.low, i.high, bits);
    return WithScramble(randomization, [&](auto scramble) {
        return PairOfReversed(scramble(x, U(xKey)), scramble(y, U(yKey)));
    });
}

template <typename U>
Vec2<UnitFloat<U>> SobolSampler::FilmPair(const Index<U> &i, uint32_t xKey, uint32_t yKey) const {
    // 64 digits of each coordinate: the upper 32 of the index fold onto the lower.
    const U yLow = SobolYReversed(U(i.low ^ i.high)), yHigh = SobolYReversed(i.high);
    const auto inPixel = [&](const U &low, const U &high) {
        return m == 0 ? low : (low >> m) | (high << (32 - m));
    };
    const U column = i.low & FirstDigits(), row = yLow & FirstDigits();
    return WithScramble(randomization, [&](auto scramble) {
        return PairOfReversed(scramble(inPixel(i.low, i.high), Mix32(U(column + xKey))),
                              scramble(inPixel(yLow, yHigh), Mix32(U(row + yKey))));
    });
}

inline SobolSampler SobolSampler::Create(ParamDict &params, const SamplerContext &context) {
    const int samples = ReadSamples(params, 16, context);
    AdvisePowerOfTwo(params, samples, kName);
    const auto randomization = Randomization(params.GetOneChoice(kRandomization));
    return SobolSampler(samples, LimitedResolution(params, kName, context), randomization,
                        ReadSeed(params, context));
}

}  // namespace pbrt
