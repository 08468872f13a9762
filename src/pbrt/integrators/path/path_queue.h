#pragma once

#include "pbrt/integrators/found_light.h"
#include "pbrt/integrators/path/path_state.h"
#include "pbrt/integrators/tracer.h"

namespace pbrt {

/// One number for each path of a batch, readable sixteen at a time.
template <typename T>
using BatchArray = std::array<T, kBatchSize + kPacketSize>;

/// Points or vectors of a queue, readable and appendable sixteen at a time.
struct BatchVectors {
    BatchArray<float> x{}, y{}, z{};

    Vector3fX16 Load(int first) const {
        const size_t at = size_t(first);
        return {LoadX16(&x[at]), LoadX16(&y[at]), LoadX16(&z[at])};
    }
    Vector3fX16 At(const UintX16 &at) const {
        return {Gather(&x[0], at), Gather(&y[0], at), Gather(&z[0], at)};
    }
    void Put(int end, const Vector3fX16 &v, LaneBits lanes) {
        const size_t at = size_t(end);
        Compress(&x[at], v.x, lanes);
        Compress(&y[at], v.y, lanes);
        Compress(&z[at], v.z, lanes);
    }
};

/// The paths of a batch that go on: their next rays and what they carry, one array per quantity.
/// Data that a path keeps from its start to its end are found by its slot instead.
class PathQueue {
  public:
    int Size() const { return size; }
    void Clear() { size = 0; }
    /// Sets whether PathState::previous has its normal: if that is read. Before the first Add.
    void KeepNormals(bool keep) { keepsNormals = keep; }

    [[gnu::always_inline]] void Add(const PathPacket &paths, LaneBits lanes) {
        const size_t end = size_t(size);
        Compress(&slot[end], paths.slot, lanes);
        o.Put(size, paths.o, lanes);
        d.Put(size, paths.d, lanes);
        Compress(&time[end], paths.time, lanes);
        p.Put(size, paths.p, lanes);
        if (keepsNormals) ns.Put(size, paths.ns, lanes);
        Compress(&bsdfPDF[end], paths.bsdfPDF, lanes);
        Compress(&etaScale[end], paths.etaScale, lanes);
        Compress(&depth[end], paths.depth, lanes);
        Compress(&anyNonSpecular[end], paths.anyNonSpecular, lanes);
        ForEachLane(lanes, [&](int i) { beta[size_t(size++)] = paths.beta[size_t(i)]; });
    }
    UintX16 SlotsAt(const UintX16 &at) const { return Gather(&slot[0], at); }
    PathPacket At(const UintX16 &at) const {
        PathPacket paths;
        paths.slot = Gather(&slot[0], at);
        paths.o = o.At(at), paths.d = d.At(at), paths.time = Gather(&time[0], at);
        paths.p = p.At(at);
        paths.ns = {};
        paths.bsdfPDF = Gather(&bsdfPDF[0], at), paths.etaScale = Gather(&etaScale[0], at);
        paths.depth = Gather(&depth[0], at);
        paths.anyNonSpecular = Gather(&anyNonSpecular[0], at);
        if (keepsNormals) paths.ns = ns.At(at);
        for (int i = 0; i < kPacketSize; ++i)
            paths.beta[size_t(i)] = beta[at[i]];
        return paths;
    }
    /// The rays of the paths at sixteen places.
    RayPacket RaysAt(const UintX16 &at) const {
        return {o.At(at), d.At(at), Broadcast<16>(Infinity), Gather(&time[0], at)};
    }
    /// Directions of sixteen successive paths; those beyond Size() are anything.
    Vector3fX16 Directions(int first) const { return d.Load(first); }

  private:
    BatchArray<uint32_t> slot{}, depth{}, anyNonSpecular{};
    BatchVectors o, d, p, ns;
    BatchArray<float> time{}, bsdfPDF{}, etaScale{};
    BatchArray<SampledSpectrum> beta{};
    int size = 0;
    bool keepsNormals = true;
};

/// Shadow rays of a batch.
class ShadowQueue {
  public:
    int Size() const { return size; }
    void Clear() { size = 0; }
    /// Rays towards points on lights; `gains`, one a lane: what the paths in `slots` gain unless
    /// something stands between.
    void Add(const UintX16 &slots, const FloatX16 &times, const Point3fX16 &from,
             const Point3fX16 &to, const std::array<SampledSpectrum, kPacketSize> &gains,
             LaneBits lanes) {
        Compress(&slot[size_t(size)], slots, lanes);
        Compress(&time[size_t(size)], times, lanes);
        o.Put(size, from, lanes);
        d.Put(size, to - from, lanes);
        ForEachLane(lanes, [&](int i) { gain[size_t(size++)] = gains[size_t(i)]; });
    }
    /// Rays that end just before the light, of sixteen places.
    RayPacket RaysAt(const UintX16 &at) const {
        return {o.At(at), d.At(at), Broadcast<16>(kShadowEnd), Gather(&time[0], at)};
    }
    /// Directions of sixteen successive rays; those beyond Size() are anything.
    Vector3fX16 Directions(int first) const { return d.Load(first); }
    uint32_t Slot(uint32_t at) const { return slot[at]; }
    SampledSpectrum Gain(uint32_t at) const { return gain[at]; }

  private:
    BatchArray<uint32_t> slot{};
    BatchArray<SampledSpectrum> gain{};
    BatchVectors o, d;
    BatchArray<float> time{};
    int size = 0;
};

}  // namespace pbrt
