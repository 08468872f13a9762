#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <span>

#include "pbrt/base/sampler.h"
#include "pbrt/samplers/padded_sobol.h"
#include "pbrt/samplers/pixel_table.h"
#include "pbrt/samplers/radical_inverse.h"
#include "pbrt/samplers/randomization.h"
#include "pbrt/samplers/sampler_params.h"
#include "pbrt/util/check.h"

namespace pbrt {

/// Randomisation of the digits of the Halton points: one random permutation for each place of each
/// dimension, or one for each place and all digits before it (Owen's nested scrambling).
enum class HaltonRandomization { PermuteDigits, None, Owen };

/// One Halton sequence (radical inverses in the bases 2, 3, 5, 7, ...; Halton 1964) over squares of
/// 128 pixels, alike in each: the bases 2 and 3 are the place in the image, in units of 2^-j of its
/// width and 3^-k of its height, so that one in 2^j 3^k points falls into a given pixel, and which
/// one follows from the digits of the pixel's place (the Chinese remainder theorem). The digits
/// after those are randomised anew in each column and each row: else few samples per pixel lie on a
/// pattern that all pixels share. The draw of the film takes these two bases, each other draw the
/// next two primes. Draws beyond the 255 primes after 2 are those of `paddedsobol`.
class HaltonSampler {
  public:
    static constexpr std::string_view kName = "halton";
    static constexpr SamplerTraits kTraits{.hasBatches = true};
    static constexpr std::array<std::string_view, 3> kExamples{
        "", "\"string randomization\" \"owen\" \"integer pixelsamples\" 30",
        "\"integer pixelsamples\" 1"};
    /// So that indices in the sequence stay below 2^31: 128 * 243 * 2^16.
    static constexpr int kMaxSamples = 1 << 16;

    explicit HaltonSampler(int samplesPerPixel = 16, Point2i fullResolution = {1, 1},
                           HaltonRandomization randomization = HaltonRandomization::PermuteDigits,
                           int seed = 0);

    static HaltonSampler Create(ParamDict &params, const SamplerContext &context);

    int SamplesPerPixel() const { return samplesPerPixel; }
    /// `dimension` counts draws of either kind; 0 <= sampleIndex < SamplesPerPixel().
    void StartPixelSample(Point2i p, int sampleIndex, int dimension = 0) {
        DCHECK(sampleIndex < SamplesPerPixel());
        pixel = p;
        sample = sampleIndex;
        index = FirstIndex(p) + uint32_t(sampleIndex) * stride;
        next = dimension;
    }
    float Get1D() {
        const int dimension = next++;
        return dimension < kDraws ? Number(dimension, 0, index) : Beyond(dimension).x;
    }
    Point2f Get2D() {
        const int dimension = next++;
        return dimension < kDraws ? Pair(dimension, index) : Beyond(dimension);
    }

    void StartBatch(std::span<const Point2i> pixels) {
        firstIndices.Fill(pixels, [&](Point2i p) { return FirstIndex(p); });
        padded.StartBatch(pixels);
    }
    FloatX16 Get1D(int dimension, UintX16 place, UintX16 sampleIndex) const {
        if (dimension >= kDraws) return padded.Get1D(dimension, place, sampleIndex);
        return Number(dimension, 0, IndexOf(place, sampleIndex));
    }
    Point2fX16 Get2D(int dimension, UintX16 place, UintX16 sampleIndex) const {
        if (dimension >= kDraws) return padded.Get2D(dimension, place, sampleIndex);
        return Pair(dimension, IndexOf(place, sampleIndex));
    }

  private:
    static constexpr int kDraws = 128;
    static constexpr int kSquare = 128;  ///< pixels a side

    /// Index of the pixel's first sample; others follow at the stride.
    uint32_t FirstIndex(Point2i p) const;
    UintX16 IndexOf(const UintX16 &place, const UintX16 &sampleIndex) const {
        const UintX16 k = Select(sampleIndex < uint32_t(samplesPerPixel), sampleIndex, UintX16{});
        return firstIndices.At(place) + k * stride;
    }
    Point2f Beyond(int dimension) {
        padded.StartPixelSample(pixel, sample, dimension);
        return padded.Get2D();
    }
    template <typename U>
    Vec2<UnitFloat<U>> Pair(int dimension, const U &i) const {
        return {Number(dimension, 0, i), Number(dimension, 1, i)};
    }
    template <typename U>
    UnitFloat<U> Number(int dimension, int coordinate, const U &i) const;
    template <typename U>
    U FilmX(const U &i) const;
    template <typename U>
    UnitFloat<U> Inverse(int which, const U &i, U key, HaltonRandomization how) const;

    int samplesPerPixel;
    HaltonRandomization randomization, filmRandomization;
    int log2Columns;  ///< j
    OddDivisor rows;  ///< 3^k
    uint32_t stride;  ///< 2^j 3^k
    uint32_t xStep,
        yStep;  ///< index modulo the stride that is 1 in one base's digits, 0 in the other's
    uint32_t seedBits;
    std::shared_ptr<const RadicalInverses> inverses;
    PaddedSobolSampler padded;
    Point2i pixel;
    int sample = 0, next = 0;
    uint32_t index = 0;
    PixelTable firstIndices;
};
static_assert(SamplerType<HaltonSampler>);

namespace detail {
/// The least power of 3 that is not below n.
inline uint32_t PowerOf3(int n) {
    uint32_t power = 1;
    while (int(power) < n)
        power *= 3;
    return power;
}
/// The multiple of a, below a * n, that is 1 modulo n; by trial, for n is small.
inline uint32_t MultipleThatIsOne(uint32_t a, uint32_t n) {
    uint32_t multiple = 0;
    while (multiple % n != 1 % n)
        multiple += a;
    return multiple;
}
}  // namespace detail

inline HaltonSampler::HaltonSampler(int samplesPerPixel, Point2i fullResolution,
                                    HaltonRandomization randomization, int seed)
    : samplesPerPixel(samplesPerPixel),
      randomization(randomization),
      filmRandomization(randomization == HaltonRandomization::None ? HaltonRandomization::None
                                                                   : HaltonRandomization::Owen),
      log2Columns(std::bit_width(uint32_t(std::clamp(fullResolution.x, 1, kSquare) - 1))),
      rows(detail::PowerOf3(std::min(fullResolution.y, kSquare))),
      stride(rows.Value() << log2Columns),
      xStep(detail::MultipleThatIsOne(rows.Value(), uint32_t(1) << log2Columns)),
      yStep(detail::MultipleThatIsOne(uint32_t(1) << log2Columns, rows.Value())),
      seedBits(uint32_t(Hash(seed, 2))),
      inverses(std::make_shared<const RadicalInverses>(2 * kDraws - 1, Hash(seed, 3))),
      padded(samplesPerPixel, Randomization::FastOwen, seed) {
    DCHECK(samplesPerPixel >= 1 && samplesPerPixel <= kMaxSamples);
}

inline uint32_t HaltonSampler::FirstIndex(Point2i p) const {
    // Digits of the pixel's place, mirrored, are those that the index must have.
    const uint32_t column = uint32_t(p.x) % kSquare;
    const uint32_t x = uint32_t(uint64_t(ReverseBits32(column)) << log2Columns >> 32);
    uint32_t y = 0;
    for (uint32_t row = uint32_t(p.y) % kSquare, power = 1; power < rows.Value(); power *= 3) {
        y = y * 3 + row % 3;
        row /= 3;
    }
    return (x * xStep + y * yStep) % stride;
}

template <typename U>
UnitFloat<U> HaltonSampler::Number(int dimension, int coordinate, const U &i) const {
    const auto keyOf = [&](int which) { return Mix32(uint32_t(which) * 0x9e3779b9 + seedBits); };
    if (dimension == kFilmDimension) {
        if (coordinate == 0) return ToUnitFloat(ReverseBits32(FilmX(i)));
        const U rest = rows.Quotient(i), row = i - rest * rows.Value();
        return Inverse(0, rest, Mix32(U(row + keyOf(0))), filmRandomization);
    }
    const int which = 2 * (dimension + (dimension < kFilmDimension ? 1 : 0)) + coordinate - 1;
    return Inverse(which, i, U(keyOf(which)), randomization);
}

/// Reversed digits.
template <typename U>
U HaltonSampler::FilmX(const U &i) const {
    const U rest = i >> log2Columns;
    const U key = Mix32(U((i & ((uint32_t(1) << log2Columns) - 1)) + seedBits));
    switch (randomization) {
        case HaltonRandomization::None:
            return rest;
        case HaltonRandomization::PermuteDigits:
            return rest ^ key;
        default:
            return OwenReversed(rest, key);
    }
}

/// Radical inverse in prime number `which` from 3 on. `key`: of Owen's scrambling.
template <typename U>
UnitFloat<U> HaltonSampler::Inverse(int which, const U &i, U key, HaltonRandomization how) const {
    using Base = RadicalInverses::Base;
    switch (how) {
        case HaltonRandomization::None:
            return (*inverses)(which, i, [](const Base &, int, const U &digit) { return digit; });
        case HaltonRandomization::PermuteDigits:
            return (*inverses)(which, i, [&](const Base &base, int place, const U &digit) {
                return inverses->Permuted(base, place, digit);
            });
        default:
            // An affine map for each node, and then the place's permutation: Owen's variance is
            // that of the pairs of digits, which are as likely as by a random permutation each.
            return (*inverses)(which, i, [&](const Base &base, int place, const U &digit) {
                const uint32_t p = base.divide.Value();
                const U factor = 1 + (((key & 0xffff) * (p - 1)) >> 16);
                const U constant = ((key >> 16) * p) >> 16;
                key = Mix32(U(key + digit + 1));
                return inverses->Permuted(base, place,
                                          base.divide.Remainder(U(digit * factor + constant)));
            });
    }
}

inline HaltonSampler HaltonSampler::Create(ParamDict &params, const SamplerContext &context) {
    constexpr static std::array<std::string_view, 3> kNames{"permutedigits", "none", "owen"};
    constexpr static ChoiceParam kRandomizationRow{
        "randomization", kNames[0], kNames, "what is done to the digits of the Halton points"};
    const int samples = ReadLimitedSamples(params, 16, kMaxSamples, kName, context);
    const int randomization = params.GetOneChoice(kRandomizationRow);
    return HaltonSampler(samples, context.fullResolution, HaltonRandomization(randomization),
                         ReadSeed(params, context));
}

}  // namespace pbrt
