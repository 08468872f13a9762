#pragma once

#include <memory>
#include <span>
#include <string>

#include "pbrt/base/ray_tracer.h"
#include "pbrt/shapes/geometry.h"

namespace pbrt {

/// Scenes of more instances than this keep those at rest in an InstanceSet: Embree's own take some
/// 700 bytes each and are 5 to 10 % faster to trace (a neck of feathers; 3.2 million leaves of two
/// triangles).
inline constexpr size_t kMostEmbreeInstances = 1 << 16;

/// The ray tracer, by Embree, which no other room knows: base/ray_tracer.h says what it does. One
/// traversal a query.
class Accel {
  public:
    Accel(std::span<const Geometry> geometries, uint32_t nTop, std::span<const ObjectRange> objects,
          std::span<const Instance> instances, int nThreads);
    ~Accel();
    Accel(Accel &&) noexcept;
    Accel &operator=(Accel &&) noexcept;

    [[nodiscard]] const std::string &Error() const;

    bool Intersect(const Ray &ray, Hit *hit) const;
    bool Occluded(const Ray &ray) const;
    float Transmittance(const Ray &ray, const NullTransmission &passing) const;

    LaneBits Intersect(const RayPacket &rays, LaneBits active, HitPacket *hits,
                       Coherence coherence = Coherence::None) const;
    LaneBits Occluded(const RayPacket &rays, LaneBits active) const;
    void Transmittance(const RayPacket &rays, LaneBits active, const NullTransmission &passing,
                       FloatX16 *passed) const;

    bool HasNullTransmission() const { return hasNullTransmission; }

    Bounds3f WorldBounds() const;
    size_t MemoryBytes() const;
    size_t PeakMemoryBytes() const;

  private:
    LaneBits IntersectSingly(const RayPacket &rays, LaneBits active, HitPacket *hits) const;

    struct Impl;
    friend struct EmbreeSceneOf;
    std::unique_ptr<Impl> impl;
    bool hasNullTransmission = false;
};
static_assert(RayTracerType<Accel>);

}  // namespace pbrt
