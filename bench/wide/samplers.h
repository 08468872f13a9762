#pragma once

#include "bench/stopwatch.h"
#include "pbrt/samplers/samplers.h"
#include "pbrt/util/vecmath_simd.h"

namespace pbrt::bench {

/// Pairs drawn in a batch of 16 pixels with 64 samples, in 15 dimensions, against the same drawn
/// sample by sample. Lanes of one register: of one pixel, as camera rays come, or of all pixels, as
/// sorted vertices do.
template <typename S>
void AddSampler(Stopwatch &watch, const std::string &name, S sampler) {
    constexpr int kLog2Pixels = 4, kLog2Samples = 6, kDimensions = 15;
    constexpr int kPixels = 1 << kLog2Pixels, kSamples = 1 << kLog2Samples;
    std::vector<Point2i> pixels;
    for (int i = 0; i < kPixels; ++i)
        pixels.push_back({i % 4 + 100, i / 4 + 60});
    const int calls = kPixels * kSamples * kDimensions;
    watch.Add(name + " scalar", calls, [=]() mutable {
        double sum = 0;
        for (const Point2i p : pixels)
            for (int index = 0; index < kSamples; ++index) {
                sampler.StartPixelSample(p, index);
                for (int d = 0; d < kDimensions; ++d) {
                    const Point2f u = sampler.Get2D();
                    sum += u.x + u.y;
                }
            }
        return sum;
    });
    for (const bool mixed : {false, true})
        watch.Add(name + (mixed ? " wide, pixels mixed" : " wide"), calls, [=]() mutable {
            FloatX16 sum{};
            sampler.StartBatch(pixels);
            for (int d = 0; d < kDimensions; ++d)
                for (uint32_t i = 0; i < kPixels * kSamples; i += kPacketSize) {
                    const UintX16 path = i + kLaneNumbers;
                    const Point2fX16 u = mixed ? sampler.Get2D(d, path & (kPixels - 1), path >> kLog2Pixels)
                                               : sampler.Get2D(d, path >> kLog2Samples, path & (kSamples - 1));
                    sum += u.x + u.y;
                }
            return double(sum[0]);
        });
}

inline void AddSamplers(Stopwatch &watch) {
    AddSampler(watch, "zsobol pair", ZSobolSampler(64, {400, 400}));
    AddSampler(watch, "stratified pair", StratifiedSampler(8, 8));
    AddSampler(watch, "independent pair", IndependentSampler(64));
    AddSampler(watch, "halton pair", HaltonSampler(64, {400, 400}));
    AddSampler(watch, "sobol pair", SobolSampler(64, {400, 400}));
    AddSampler(watch, "paddedsobol pair", PaddedSobolSampler(64));
    AddSampler(watch, "pmj02bn pair", PMJ02BNSampler(64));
}

}  // namespace pbrt::bench
