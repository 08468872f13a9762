#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pbrt/base/hit.h"
#include "pbrt/util/transform.h"

namespace pbrt {

struct Geometry;  // shapes/geometry.h

/// A copy of an object, at rest or in motion.
struct Instance {
    uint32_t object;                   ///< index into the objects given to the ray tracer
    AffineTransform renderFromObject;  ///< in motion: at ray time 0
    /// Null at rest, else more keys, one at least, at equal steps of time, the last at ray time 1.
    /// From key to key each matrix entry is linear. (Behind a pointer: a scene may have millions.)
    std::unique_ptr<const std::vector<Transform>> later = {};

    bool Moves() const { return later != nullptr; }
    size_t NKeys() const { return Moves() ? later->size() + 1 : 1; }
    Transform Key(size_t i) const { return i == 0 ? renderFromObject.Whole() : (*later)[i - 1]; }
};

/// Range of geometries [first, last) that an instance repeats.
struct ObjectRange {
    uint32_t first, last;
};

/// Called for each surface that passes light on a shadow ray's way. Returns the fraction that
/// passes, per wavelength folded to one number, in [0, 1]. `ray` is the query's own, also for hits
/// in instances; hit.t runs along it.
struct NullTransmission {
    virtual float operator()(const Hit &hit, const Ray &ray) const = 0;

  protected:
    ~NullTransmission() = default;
};

/// Likeness of a packet's rays. It decides how the nearest hits are looked for, not what
/// they are. (Shadow rays gain nothing, not even from one pixel's points to one light.)
enum class Coherence {
    None,
    Octant,  ///< most have directions of the same signs: twice as fast in scenes of few primitives
    Alike,   ///< start side by side in nearly one direction, as a pixel's camera rays: four times
};

// Limits of the ray tracer that the rooms below it keep to; those of lengths are in util/range.h.

/// Segments of one CurveSet: each may be traced as 32 numbered parts, and numbers have 32 bits.
inline constexpr size_t kMaxCurveSegments = size_t(1) << 27;
/// Points and vertices of meshes are read 16 bytes at a time: behind the last one of 12 bytes the
/// vector keeps room for one more, which must be its own memory and need not be filled.
inline constexpr size_t kPointsBehindLast = 1;

/// A ray tracer: finds what rays meet. Built once, immutable from then on; all queries are
/// thread-safe and allocate nothing.
///
///   A(geometries, nTop, objects, instances, nThreads)
///       builds. Geometries [0, nTop) stand in the scene as they are; the others only through
///       instances. The spans must outlive the tracer. nThreads: for building; 0: all cores.
///       Does not throw: failures are told by Error().
///   Error()
///       a sentence that says why it could not be built, as when memory ran out; empty where all
///       is well. The caller must read it: with an error nothing below may be called.
///   Intersect(ray, &hit)
///       true, and *hit set, for the nearest hit in (0, ray.tMax]. Places where the geometry's
///       alpha cuts the surface away are passed over, by a hash of ray and primitive, so that one
///       ray always meets the same. A miss leaves *hit alone. A geometry of constant alpha 0 is
///       never met.
///   Occluded(ray)
///       true where anything opaque stands in (0, ray.tMax], surfaces with null transmission being
///       opaque.
///   Transmittance(ray, passing)
///       fraction of light in [0, 1] that passes along the ray up to tMax: 0 where something opaque
///       stands, else the product of `passing` over the surfaces with hasNullTransmission, each
///       asked once for each crossing, any number of them.
///   the same for packets
///       of the active lanes, as bits; the others are neither read nor written. A lane finds what a
///       single ray finds, but where rounding decides (edges, grazing rays).
///       Intersect returns the lanes that hit, Occluded those that are blocked.
///   HasNullTransmission()
///       whether any geometry that can be met passes light: else Occluded says all.
///   WorldBounds()
///       of all that stands in the scene, instances included, over the whole time.
///   MemoryBytes(), PeakMemoryBytes()
///       what it holds beside the shapes, and the most it held while it was built.
template <typename A>
concept RayTracerType = std::movable<A> && std::constructible_from < A,
        std::span<const Geometry>, uint32_t, std::span<const ObjectRange>,
        std::span<const Instance>,
int > &&requires(const A a, const Ray &ray, Hit *hit, const NullTransmission &passing,
                 const RayPacket &rays, LaneBits active, HitPacket *hits, Coherence coherence,
                 FloatX16 *passed) {
    { a.Error() } -> std::same_as<const std::string &>;
    { a.Intersect(ray, hit) } -> std::same_as<bool>;
    { a.Occluded(ray) } -> std::same_as<bool>;
    { a.Transmittance(ray, passing) } -> std::same_as<float>;
    { a.Intersect(rays, active, hits, coherence) } -> std::same_as<LaneBits>;
    { a.Occluded(rays, active) } -> std::same_as<LaneBits>;
    { a.Transmittance(rays, active, passing, passed) } -> std::same_as<void>;
    { a.HasNullTransmission() } -> std::same_as<bool>;
    { a.WorldBounds() } -> std::same_as<Bounds3f>;
    { a.MemoryBytes() } -> std::same_as<size_t>;
    { a.PeakMemoryBytes() } -> std::same_as<size_t>;
};

}  // namespace pbrt
