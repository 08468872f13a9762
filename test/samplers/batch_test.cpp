#include <gtest/gtest.h>

#include "pbrt/samplers/batch_sampler.h"
#include "pbrt/util/rng.h"
#include "samplers/sampler_examples.h"

namespace pbrt {
namespace {

constexpr Point2i kResolution{300, 500};

std::vector<Sampler> AllSamplers() {
    std::vector<Sampler> samplers{StratifiedSampler(5, 3, false, 5),
                                  ZSobolSampler(1 << 20, kResolution, Randomization::Owen, 8),
                                  ZSobolSampler(1, {1, 1}, Randomization::None, 0)};
    for (const Sampler &example : SamplerExamples(kResolution, 7))
        samplers.push_back(example);
    return samplers;
}

std::vector<Point2i> Pixels(size_t n) {
    Rng rng(n);
    std::vector<Point2i> pixels(n);
    for (Point2i &p : pixels)
        p = {int(rng.Below(uint32_t(kResolution.x))), int(rng.Below(uint32_t(kResolution.y)))};
    return pixels;
}

/// Draws of a batch and one by one, in random order of dimensions, pixels and samples; exactly.
template <typename S>
void ExpectSameNumbers(S alone, const std::vector<Point2i> &pixels, uint64_t seed) {
    BatchSampler<S> sampler(alone);
    sampler.StartBatch(pixels);
    Rng rng(seed);
    for (int round = 0; round < 60; ++round) {
        const int dimension = int(rng.Below(round < 30 ? 20 : 1000));
        UintX16 pixel, index;
        for (int i = 0; i < kPacketSize; ++i) {
            pixel.Set(i, rng.Below(uint32_t(pixels.size())));
            index.Set(i, rng.Below(uint32_t(sampler.SamplesPerPixel())));
        }
        const FloatX16 single = sampler.Get1D(dimension, pixel, index);
        const Point2fX16 pair = sampler.Get2D(dimension, pixel, index);
        for (int i = 0; i < kPacketSize; ++i) {
            const Point2i p = pixels[pixel[i]];
            alone.StartPixelSample(p, int(index[i]), dimension);
            ASSERT_EQ(single[i], alone.Get1D()) << dimension;
            alone.StartPixelSample(p, int(index[i]), dimension);
            ASSERT_EQ((Point2f{pair.x[i], pair.y[i]}), alone.Get2D()) << dimension;
        }
    }
}

TEST(SamplerBatch, SameNumbersAsOneByOne) {
    for (const Sampler &sampler : AllSamplers()) {
        std::visit(
            [](auto s) {
                for (size_t n : {1, 16, 17, 200, 3})
                    ExpectSameNumbers(s, Pixels(n), n + 1);
            },
            sampler);
    }
}

TEST(SamplerBatch, ASecondBatchForgetsTheFirst) {
    for (Sampler &sampler : AllSamplers()) {
        std::visit(
            []<typename S>(const S &sampler) {
                BatchSampler<S> s(sampler), fresh = s;
                s.StartBatch(Pixels(40));
                s.Get2D(5, kLaneNumbers, UintX16{});
                s.StartBatch(Pixels(20));
                fresh.StartBatch(Pixels(20));
                const FloatX16 a = s.Get2D(5, kLaneNumbers, UintX16{}).y;
                const FloatX16 b = fresh.Get2D(5, kLaneNumbers, UintX16{}).y;
                for (int i = 0; i < kPacketSize; ++i)
                    EXPECT_EQ(a[i], b[i]);
            },
            sampler);
    }
}

/// Lanes whose numbers nobody wants may hold any index, and disturb no other.
TEST(SamplerBatch, AnyIndexInLanesNotWanted) {
    for (Sampler &sampler : AllSamplers()) {
        std::visit(
            []<typename S>(const S &sampler) {
                BatchSampler<S> s(sampler);
                s.StartBatch(Pixels(16));
                const UintX16 good{}, wild = Select((kLaneNumbers & 1u) == 0u, good, ~kLaneNumbers);
                const FloatX16 a = s.Get1D(3, kLaneNumbers, good),
                               b = s.Get1D(3, kLaneNumbers, wild);
                for (int i = 0; i < kPacketSize; i += 2)
                    EXPECT_EQ(a[i], b[i]);
            },
            sampler);
    }
}

/// The adapter of samplers without batches, where their own can tell what is right.
TEST(SamplerBatch, OneByOneGivesTheSameNumbers) {
    const IndependentSampler sampler(16, 3);
    const std::vector<Point2i> pixels = Pixels(20);
    IndependentSampler own = sampler;
    OneByOneSampler<IndependentSampler> oneByOne(sampler);
    own.StartBatch(pixels);
    oneByOne.StartBatch(pixels);
    const UintX16 index = kLaneNumbers & 15u;
    for (const int dimension : {0, 3, 100}) {
        const FloatX16 a = own.Get1D(dimension, kLaneNumbers, index),
                       b = oneByOne.Get1D(dimension, kLaneNumbers, index);
        const Point2fX16 p = own.Get2D(dimension, kLaneNumbers, index),
                         q = oneByOne.Get2D(dimension, kLaneNumbers, index);
        for (int i = 0; i < kPacketSize; ++i) {
            EXPECT_EQ(a[i], b[i]);
            EXPECT_EQ(Lane(p, i), Lane(q, i));
        }
    }
    oneByOne.Get1D(0, kLaneNumbers, ~index);  // any index in lanes that are not wanted
}

}  // namespace
}  // namespace pbrt
