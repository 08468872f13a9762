#pragma once

#include <span>

#include "pbrt/cpu/path_queue.h"

namespace pbrt {

/// Some samples of some pixels.
struct Batch {
    std::span<const Point2i> pixels;
    int firstSample, lastSample;  ///< [first, last) of each pixel

    int SamplesPerPixel() const { return lastSample - firstSample; }
    int Size() const { return int(pixels.size()) * SamplesPerPixel(); }
};

/// The paths of a batch between two steps, and what they have gathered.
struct PathBatch {
    PathQueue queues[2], *queue = &queues[0], *next = &queues[1];
    ShadowQueue shadows;
    std::array<HitPacket, kBatchSize / kWide> hits;  ///< of the queue
    // By slot: a path's number in the batch, pixel by pixel.
    BatchArray<uint32_t> pixel{}, sample{};  ///< the pixel's place in Batch::pixels
    BatchArray<SampledSpectrum> L;
    BatchArray<SampledWavelengths> lambda;

    Hit HitOf(int at) const {
        const HitPacket &h = hits[size_t(at / kWide)];
        const int i = at % kWide;
        return {h.t[i], h.u[i], h.v[i], h.geometry[i], h.primitive[i], h.instance[i]};
    }
    HitPacket HitsAt(WideUint at) const {
        HitPacket packet;
        for (int i = 0; i < kWide; ++i) {
            const HitPacket &h = hits[at[i] / kWide];
            const uint32_t k = at[i] % kWide;
            packet.t[i] = h.t[k], packet.u[i] = h.u[k], packet.v[i] = h.v[k];
            packet.geometry[i] = h.geometry[k], packet.primitive[i] = h.primitive[k];
            packet.instance[i] = h.instance[k];
        }
        return packet;
    }
};

/// The random numbers of one vertex of sixteen paths, made when asked for.
template <typename SamplerT>
struct VertexDraws {
    SamplerT &sampler;
    int dimension;
    WideUint pixel, index;  ///< the pixel's place in the batch; which of its samples

    WideFloat Light() { return sampler.Get1D(dimension, pixel, index); }
    WidePoint2f LightPoint() { return sampler.Get2D(dimension + 1, pixel, index); }
    WideFloat Lobe() { return sampler.Get1D(dimension + 2, pixel, index); }
    WidePoint2f Direction() { return sampler.Get2D(dimension + 3, pixel, index); }
    WideFloat Roulette() { return sampler.Get1D(dimension + 4, pixel, index); }
};

}  // namespace pbrt
