#pragma once

#include <array>
#include <span>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/blue_noise.h"
#include "pbrt/samplers/permutation.h"
#include "pbrt/samplers/pixel_table.h"
#include "pbrt/samplers/randomization.h"
#include "pbrt/samplers/sampler_params.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// Progressive multi-jittered (0,2)-samples with blue noise between the pixels (Christensen,
/// Kensler and Kilpatrick 2018). A draw's pairs are the first points of a (0,2)-sequence under
/// nested uniform scrambling, one scrambling for each draw: whatever defines pmj02 sets, one point
/// in each elementary interval of each first 2^k, holds for these (Helmer, Christensen and Kensler
/// 2021, "Stochastic Generation of (t, s) Sample Sequences"), so no tables of sets are kept. Where
/// pbrt-v4 moves a set on the torus by the pixel's blue noise, here the digits of the blue noise
/// are added to those of the samples without carry, which keeps every draw of a pixel a net. Single
/// numbers lie one in each of n intervals, where the pixel's blue noise says.
///
/// The film's samples come in the sequence's order, so that their first 2^k are a net for each k;
/// the others in a random order for each pixel and draw, without which draws depend on each other
/// (see BitPermutation).
class PMJ02BNSampler {
  public:
    static constexpr std::string_view kName = "pmj02bn";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 3> kExamples{"", "\"integer pixelsamples\" 64",
                                                               "\"integer pixelsamples\" 1"};
    /// As pbrt-v4's tables have.
    static constexpr int kMaxSamples = 1 << 16;

    /// samplesPerPixel: up to kMaxSamples.
    explicit PMJ02BNSampler(int samplesPerPixel = 16, int seed = 0)
        : order(uint32_t(samplesPerPixel)),
          width(1 / float(samplesPerPixel)),
          seed(seed),
          noise(&BlueNoise::Get()) {
        DCHECK(samplesPerPixel >= 1 && samplesPerPixel <= kMaxSamples);
    }

    static PMJ02BNSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return int(order.Size()); }
    /// `dimension` counts draws of either kind; 0 <= sampleIndex < SamplesPerPixel().
    void StartPixelSample(Point2i p, int sampleIndex, int dimension = 0) {
        DCHECK(sampleIndex < SamplesPerPixel());
        index = uint32_t(sampleIndex);
        const uint64_t bits = Hash(seed, p);
        pixel = {uint32_t(bits), uint32_t(bits >> 32), PlaceOf(p)};
        next = dimension;
    }
    float Get1D() { return Single(next++, pixel, index); }
    Point2f Get2D() { return Pair(next++, pixel, index); }

    void StartBatch(std::span<const Point2i> pixels);
    FloatX16 Get1D(int dimension, UintX16 place, UintX16 sampleIndex) const {
        return Single(dimension, PixelAt(place), Clamped(sampleIndex));
    }
    Point2fX16 Get2D(int dimension, UintX16 place, UintX16 sampleIndex) const {
        return Pair(dimension, PixelAt(place), Clamped(sampleIndex));
    }

  private:
    template <typename U>
    struct Pixel {
        U low, high;  ///< 64 random bits
        U place;      ///< in the blue noise's square, x + kSide y, and random bits of the square
    };

    static uint32_t PlaceOf(Point2i p) {
        constexpr int kSide = BlueNoise::kSide;
        const auto square = uint32_t(Hash(p.x / kSide, p.y / kSide));
        return uint32_t(p.x % kSide + p.y % kSide * kSide) | (square << BlueNoise::kBits);
    }
    Pixel<UintX16> PixelAt(const UintX16 &place) const {
        const Uint64X16 bits = hashes.At(place);
        return {LowHalf(bits), HighHalf(bits), places.At(place)};
    }
    UintX16 Clamped(const UintX16 &k) const { return Select(k < order.Size(), k, UintX16{}); }

    uint32_t Noise(uint32_t i) const { return noise->Reversed()[i]; }
    UintX16 Noise(const UintX16 &i) const { return Gather(noise->Reversed(), i); }
    /// 32 reversed digits at a pixel: those of the blue noise, moved on its torus by an amount for
    /// each square of pixels and each key, and then hashed ones.
    template <typename U>
    U Shift(const Pixel<U> &p, uint32_t key, const U &random) const {
        constexpr uint32_t kX = BlueNoise::kSide - 1, kY = kX << BlueNoise::kLog2Side;
        const U move = Mix32(U((p.place >> BlueNoise::kBits) + key));
        const U x = (p.place + move) & kX, y = ((p.place & kY) + ((move >> 16) & kY)) & kY;
        return Noise(U(x | y)) | (random << BlueNoise::kBits);
    }
    /// Key of a draw in all pixels.
    uint32_t KeyOf(int dimension) const {
        return Mix32(uint32_t(dimension) * 0x9e3779b9 + uint32_t(Hash(seed, 5)));
    }
    template <typename U>
    UnitFloat<U> Single(int dimension, const Pixel<U> &p, const U &k) const;
    template <typename U>
    Vec2<UnitFloat<U>> Pair(int dimension, const Pixel<U> &p, const U &k) const;

    Permutation order;
    float width;  ///< of the intervals of single numbers
    int seed;
    const BlueNoise *noise;
    Pixel<uint32_t> pixel{};
    uint32_t index = 0;
    int next = 0;  ///< dimension
    PixelHashes hashes;
    PixelTable places;
};
static_assert(SamplerType<PMJ02BNSampler>);

inline void PMJ02BNSampler::StartBatch(std::span<const Point2i> pixels) {
    hashes.Start(pixels, seed);
    places.Resize(pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i)
        places[i] = PlaceOf(pixels[i]);
}

template <typename U>
UnitFloat<U> PMJ02BNSampler::Single(int dimension, const Pixel<U> &p, const U &k) const {
    const uint32_t step = uint32_t(dimension) * 0x9e3779b9, key = KeyOf(dimension);
    const U a = Mix32(p.low + step), b = Mix32(p.high + step);
    const auto inInterval = ToUnitFloat(ReverseBits32(Shift(p, key, a)));
    const auto interval = Convert<float>(BitCast<int32_t>(order(k, a, b)));
    return Min((interval + inInterval) * width, OneMinusEpsilon);
}

template <typename U>
Vec2<UnitFloat<U>> PMJ02BNSampler::Pair(int dimension, const Pixel<U> &p, const U &k) const {
    const uint32_t step = uint32_t(dimension) * 0x9e3779b9, key = KeyOf(dimension);
    const uint32_t xKey = Mix32(key + 1), yKey = Mix32(key + 2);
    const U a = Mix32(p.low + step), b = Mix32(p.high + step);
    const U point = dimension == kFilmDimension ? k : order(k, a, b);
    return PairOfReversed(U(FastOwenReversed(point, U(xKey)) ^ Shift(p, xKey, a)),
                          U(FastOwenReversed(SobolYReversed(point), U(yKey)) ^ Shift(p, yKey, b)));
}

inline PMJ02BNSampler PMJ02BNSampler::Create(ParamDict &params, const SamplerContext &context) {
    const int samples = ReadLimitedSamples(params, 16, kMaxSamples, kName, context);
    AdvisePowerOfFour(params, samples, kName);
    return PMJ02BNSampler(samples, ReadSeed(params, context));
}

}  // namespace pbrt
