#pragma once

#include <array>

#include "pbrt/accel/packet.h"
#include "pbrt/cpu/path_state.h"

namespace pbrt {

/// So many paths are traced together: enough that packets stay full when most have ended, few
/// enough that their state stays in a core's own cache.
inline constexpr int kBatchSize = 1024;

/// One number for each path of a batch, readable sixteen at a time.
template <typename T>
using BatchArray = std::array<T, kBatchSize + kWide>;

/// The paths of a batch that go on: their next rays and what they carry, one array per quantity.
/// What a path keeps from its start to its end is found by its slot instead.
class PathQueue {
  public:
    int Size() const { return size; }
    void Clear() { size = 0; }

    void Add(uint32_t pathSlot, const PathState &path) {
        const int at = size++;
        slot[at] = pathSlot;
        Put(&o, at, path.ray.o);
        Put(&d, at, path.ray.d);
        time[at] = path.ray.time;
        beta[at] = path.beta;
        Put(&p, at, path.previous.p);
        Put(&n, at, path.previous.n);
        Put(&ns, at, path.previous.ns);
        bsdfPDF[at] = path.bsdfPDF;
        etaScale[at] = path.etaScale;
        depth[at] = uint32_t(path.depth);
        anyNonSpecular[at] = path.anyNonSpecular;
    }
    /// Sixteen paths side by side.
    struct Lanes {
        WideUint slot;
        WidePoint3f o;
        WideVector3f d;
        WideFloat time;
        WidePoint3f p;  ///< of PathState::previous
        WideNormal3f n, ns;
        WideFloat bsdfPDF, etaScale;
        WideUint depth, anyNonSpecular;
        const SampledSpectrum *beta;  ///< one a lane
    };
    void Add(const Lanes &paths, LaneBits lanes) {
        StoreLanes(&slot[size_t(size)], paths.slot, lanes);
        Put(&o, paths.o, lanes);
        Put(&d, paths.d, lanes);
        StoreLanes(&time[size_t(size)], paths.time, lanes);
        Put(&p, paths.p, lanes);
        Put(&n, paths.n, lanes);
        Put(&ns, paths.ns, lanes);
        StoreLanes(&bsdfPDF[size_t(size)], paths.bsdfPDF, lanes);
        StoreLanes(&etaScale[size_t(size)], paths.etaScale, lanes);
        StoreLanes(&depth[size_t(size)], paths.depth, lanes);
        StoreLanes(&anyNonSpecular[size_t(size)], paths.anyNonSpecular, lanes);
        ForEachLane(lanes, [&](int i) { beta[size_t(size++)] = paths.beta[i]; });
    }
    PathState At(int at) const {
        PathState path;
        path.ray = {Get(o, at), Get(d, at), Infinity, time[at]};
        path.beta = beta[at];
        path.previous = {Get(p, at), Get(n, at), Get(ns, at)};
        path.bsdfPDF = bsdfPDF[at];
        path.etaScale = etaScale[at];
        path.depth = int(depth[at]);
        path.anyNonSpecular = anyNonSpecular[at] != 0;
        return path;
    }
    /// The rays of sixteen successive paths; those beyond Size() are anything finite.
    RayPacket Rays(int first) const {
        return {Load(o, first), Load(d, first), Broadcast16(Infinity), LoadWide(&time[first])};
    }

    /// The rays at sixteen places.
    RayPacket RaysAt(WideUint at) const {
        return {GatherAt(o, at), GatherAt(d, at), Broadcast16(Infinity), Gather(&time[0], at)};
    }

    struct Vectors {
        BatchArray<float> x{}, y{}, z{};
    };
    BatchArray<uint32_t> slot{}, depth{}, anyNonSpecular{};
    Vectors o, d;
    Vectors p, n, ns;  ///< of PathState::previous
    BatchArray<float> time{}, bsdfPDF{}, etaScale{};
    BatchArray<SampledSpectrum> beta{};

  private:
    static void Put(Vectors *to, int at, Vector3f v) {
        to->x[at] = v.x, to->y[at] = v.y, to->z[at] = v.z;
    }
    static Vector3f Get(const Vectors &from, int at) {
        return {from.x[at], from.y[at], from.z[at]};
    }
    static WideVector3f Load(const Vectors &from, int at) {
        return {LoadWide(&from.x[at]), LoadWide(&from.y[at]), LoadWide(&from.z[at])};
    }
    void Put(Vectors *to, const WideVector3f &v, LaneBits lanes) {
        StoreLanes(&to->x[size_t(size)], v.x, lanes);
        StoreLanes(&to->y[size_t(size)], v.y, lanes);
        StoreLanes(&to->z[size_t(size)], v.z, lanes);
    }
    static WideVector3f GatherAt(const Vectors &from, WideUint at) {
        return {Gather(&from.x[0], at), Gather(&from.y[0], at), Gather(&from.z[0], at)};
    }
    int size = 0;
};

/// Shadow rays of a batch.
class ShadowQueue {
  public:
    int Size() const { return size; }
    void Clear() { size = 0; }
    void Add(uint32_t pathSlot, float rayTime, const ShadowTest &test) {
        const int at = size++;
        const Vector3f way = test.to - test.from;
        slot[at] = pathSlot;
        ox[at] = test.from.x, oy[at] = test.from.y, oz[at] = test.from.z;
        dx[at] = way.x, dy[at] = way.y, dz[at] = way.z;
        time[at] = rayTime;
        light[at] = test.light;
    }
    /// `gain`: one a lane.
    void Add(const WideUint &slots, const WideFloat &times, const WidePoint3f &from,
             const WidePoint3f &to, const SampledSpectrum *gain, LaneBits lanes) {
        const WideVector3f way = to - from;
        const size_t at = size_t(size);
        StoreLanes(&slot[at], slots, lanes);
        StoreLanes(&ox[at], from.x, lanes), StoreLanes(&oy[at], from.y, lanes);
        StoreLanes(&oz[at], from.z, lanes), StoreLanes(&dx[at], way.x, lanes);
        StoreLanes(&dy[at], way.y, lanes), StoreLanes(&dz[at], way.z, lanes);
        StoreLanes(&time[at], times, lanes);
        ForEachLane(lanes, [&](int i) { light[size_t(size++)] = gain[i]; });
    }
    /// As far as just before the light.
    RayPacket Rays(int first) const {
        return {{LoadWide(&ox[first]), LoadWide(&oy[first]), LoadWide(&oz[first])},
                {LoadWide(&dx[first]), LoadWide(&dy[first]), LoadWide(&dz[first])},
                Broadcast16(1 - 1e-4f),
                LoadWide(&time[first])};
    }

    BatchArray<uint32_t> slot{};
    BatchArray<SampledSpectrum> light{};

  private:
    BatchArray<float> ox{}, oy{}, oz{}, dx{}, dy{}, dz{}, time{};
    int size = 0;
};

}  // namespace pbrt
