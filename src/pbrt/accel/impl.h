#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <string>
#include <vector>

#include "pbrt/accel/accel.h"
#include "pbrt/accel/curve_chords.h"
#include "pbrt/accel/instance_set.h"
#include "pbrt/accel/native.h"
#include "pbrt/accel/user_geometry.h"

namespace pbrt {

/// Bytes allocated, counted by any number of threads.
struct MemoryUse {
    std::atomic<int64_t> now{0}, most{0};

    void Add(int64_t bytes) {
        const int64_t sum = now.fetch_add(bytes, std::memory_order_relaxed) + bytes;
        int64_t before = most.load(std::memory_order_relaxed);
        while (before < sum &&
               !most.compare_exchange_weak(before, sum, std::memory_order_relaxed)) {
        }
    }
};

/// Embree's first complaint. Noted without allocation, for it is mostly that memory ran out.
struct EmbreeFailure {
    RTCError code = RTC_ERROR_NONE;
    std::array<char, 256> text{};

    void Note(RTCError error, const char *why);
    std::string Sentence() const;
};

struct Accel::Impl {
    std::span<const Geometry> geometries;
    std::span<const ObjectRange> objects;
    std::span<const Instance> instances;
    uint32_t nTop;
    size_t nUser = 0, nOther = 0;  ///< primitives met by callbacks and by Embree, repeated ones too
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<RTCScene> objectScenes;
    std::vector<GeometryRecord> records;  ///< one a geometry
    std::deque<PlacedSet> placed;         ///< one a scene that has some
    std::deque<CurveRecord> curves;       ///< one a set of curves
    InstanceSet resting;                  ///< instances that are not Embree's
    MemoryUse memory;                     ///< of Embree and of `curves`
    EmbreeFailure failure;
    std::string error;

    Impl(std::span<const Geometry> geometries, uint32_t nTop, std::span<const ObjectRange> objects,
         std::span<const Instance> instances)
        : geometries(geometries), objects(objects), instances(instances), nTop(nTop) {}
    ~Impl();
    Impl(const Impl &) = delete;
    Impl &operator=(const Impl &) = delete;

    void Build(int nThreads);
    void BuildScenes();
    bool Failed() const { return failure.code != RTC_ERROR_NONE; }
    void Count(uint32_t first, uint32_t last);
    /// Whether rays of one octant should be traced as coherent ones.
    bool IsSmall() const { return nUser <= 500 && nOther <= 100; }
    /// Whether lanes of incoherent packets had better be traced one by one: measured on rooms full
    /// of spheres, where packets lose from there on.
    bool IntersectsSingly() const { return nUser > 1000; }
    bool OccludesSingly() const { return nUser > 3000; }
    /// Null where it fails.
    RTCScene NewScene(uint32_t first, uint32_t last, uint32_t placedId);
    RTCGeometry NewGeometry(const GeometryRecord &record);
    RTCGeometry NewNative(const GeometryRecord &record, const TriangleMesh &mesh);
    RTCGeometry NewNative(const GeometryRecord &record, const BilinearMesh &mesh);
    RTCGeometry NewNative(const GeometryRecord &record, const CurveSet &set);
    void AttachInstances();
    void AttachInstance(uint32_t index);
    void Attach(RTCScene target, RTCGeometry geometry, uint32_t id);
};

}  // namespace pbrt
