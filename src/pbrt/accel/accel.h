#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pbrt/accel/packet.h"
#include "pbrt/shapes/shape.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// What traversal must know of a shape beside its form.
struct Geometry {
    Shape shape;
    int material = 0;                  ///< index into RenderScene::materials
    int firstLight = -1;               ///< light of primitive 0; -1: not emissive
    bool sharedLight = false;          ///< all primitives are parts of that one light
    bool hasNullTransmission = false;  ///< surface with gaps: shadow rays ask for its transmittance
    FloatTexture alpha = 1.f;          ///< constant 1: no test
};

struct Instance {
    uint32_t object;  ///< index into the objects given to Accel
    /// Keys at ray times 0 and 1.
    std::array<Transform, 2> renderFromObject;
    bool moving = false;
    /// More keys between those, at equal steps of time. From key to key each matrix entry is
    /// linear.
    std::vector<Transform> between = {};

    size_t NKeys() const { return moving ? between.size() + 2 : 1; }
    const Transform &Key(size_t i) const {
        return i == 0               ? renderFromObject[0]
               : i > between.size() ? renderFromObject[1]
                                    : between[i - 1];
    }
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

/// The only room that calls Embree. Immutable after construction; all queries are thread-safe.
class Accel {
  public:
    /// Geometries [0, nTop) stand in the scene as they are; the others only through instances.
    /// The spans must outlive the Accel.
    Accel(std::span<const Geometry> geometries, uint32_t nTop, std::span<const ObjectRange> objects,
          std::span<const Instance> instances, int nThreads);
    ~Accel();
    Accel(Accel &&) noexcept;
    Accel &operator=(Accel &&) noexcept;

    /// Why it could not be built, as when memory ran out; empty where all is well. Queries are
    /// allowed only then.
    const std::string &Error() const;

    /// Nearest hit in (0, ray.tMax]; alpha cut-outs are passed over, by a hash of ray and
    /// primitive.
    bool Intersect(const Ray &ray, Hit *hit) const;
    /// True where anything opaque stands in (0, ray.tMax]. One traversal.
    bool Occluded(const Ray &ray) const;
    /// Fraction of light that passes along the ray: 0 where opaque, the product of `gaps` over
    /// surfaces with hasNullTransmission, any number of them. One traversal.
    float Transmittance(const Ray &ray, const NullTransmission &gaps) const;

    // The same for the active lanes of a packet; other lanes are neither read nor written. A lane
    // finds what a single ray finds, but where rounding decides (edges, grazing rays).

    /// Lanes that hit; of `hits` these alone are written.
    LaneBits Intersect(const RayPacket &rays, LaneBits active, HitPacket *hits,
                       Coherence coherence = Coherence::None) const;
    /// Lanes where anything opaque stands.
    LaneBits Occluded(const RayPacket &rays, LaneBits active) const;
    void Transmittance(const RayPacket &rays, LaneBits active, const NullTransmission &gaps,
                       FloatX16 *passed) const;

    bool HasNullTransmission() const { return hasGaps; }

    Bounds3f WorldBounds() const;
    size_t MemoryBytes() const;      ///< what traversal holds beside the shapes
    size_t PeakMemoryBytes() const;  ///< the most it held, which is while Embree builds
    void *EmbreeScene() const;       ///< the RTCScene, for benchmarks of Embree alone

  private:
    LaneBits IntersectSingly(const RayPacket &rays, LaneBits active, HitPacket *hits) const;

    struct Impl;
    std::unique_ptr<Impl> impl;
    bool hasGaps = false;
};

}  // namespace pbrt
