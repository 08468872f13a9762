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
    // By place in the queue: what the ray meets.
    BatchArray<float> t{}, u{}, v{};
    BatchArray<uint32_t> geometry{}, primitive{}, instance{}, material{};
    // By slot: a path's number in the batch, pixel by pixel.
    BatchArray<uint32_t> pixel{}, sample{};  ///< the pixel's place in Batch::pixels
    BatchArray<SampledSpectrum> L{};
    BatchArray<SampledWavelengths> lambda{};

    void SetHits(int first, const HitPacket &hits) {
        const size_t at = size_t(first);
        StoreWide(hits.t, &t[at]);
        StoreWide(hits.u, &u[at]);
        StoreWide(hits.v, &v[at]);
        StoreWide(hits.geometry, &geometry[at]);
        StoreWide(hits.primitive, &primitive[at]);
        StoreWide(hits.instance, &instance[at]);
    }
    HitPacket HitsAt(const WideUint &at) const {
        return {Gather(&t[0], at),        Gather(&u[0], at),         Gather(&v[0], at),
                Gather(&geometry[0], at), Gather(&primitive[0], at), Gather(&instance[0], at)};
    }
};

}  // namespace pbrt
