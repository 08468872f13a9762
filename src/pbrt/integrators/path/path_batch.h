#pragma once

#include "pbrt/integrators/path/path_queue.h"

namespace pbrt {

/// The paths of a batch between two steps, and what they have gathered.
struct PathBatch {
    PathQueue queues[2], *queue = &queues[0], *next = &queues[1];
    ShadowQueue shadows;
    ClampCounts *clamped = nullptr;  ///< of the thread
    // By place in the queue: what the ray meets.
    BatchArray<float> t{}, u{}, v{};
    BatchArray<uint32_t> geometry{}, primitive{}, instance{}, material{};
    // By slot: a path's number in the batch, pixel by pixel.
    BatchArray<uint32_t> pixel{}, sample{};  ///< the pixel's place in the tile
    BatchArray<SampledSpectrum> L{};
    BatchArray<SampledWavelengths> lambda{};

    void SetHits(const UintX16 &at, const HitPacket &hits, LaneBits lanes) {
        Scatter(&t[0], at, hits.t, lanes);
        Scatter(&u[0], at, hits.u, lanes);
        Scatter(&v[0], at, hits.v, lanes);
        Scatter(&geometry[0], at, hits.geometry, lanes);
        Scatter(&primitive[0], at, hits.primitive, lanes);
        Scatter(&instance[0], at, hits.instance, lanes);
    }
    HitPacket HitsAt(const UintX16 &at) const {
        return {Gather(&t[0], at),        Gather(&u[0], at),         Gather(&v[0], at),
                Gather(&geometry[0], at), Gather(&primitive[0], at), Gather(&instance[0], at)};
    }
};

}  // namespace pbrt
