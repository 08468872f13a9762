#include <limits>

#include "pbrt/accel/impl.h"

namespace pbrt {
namespace {

void SetRays(const RayPacket &rays, RTCRay16 *r) {
    constexpr UintX16 kLane{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    StoreWide(rays.o.x, r->org_x);
    StoreWide(rays.o.y, r->org_y);
    StoreWide(rays.o.z, r->org_z);
    StoreWide(Broadcast16(std::numeric_limits<float>::min()), r->tnear);
    StoreWide(rays.d.x, r->dir_x);
    StoreWide(rays.d.y, r->dir_y);
    StoreWide(rays.d.z, r->dir_z);
    StoreWide(rays.time, r->time);
    StoreWide(rays.tMax, r->tfar);
    StoreWide(UintX16{} + ~0u, r->mask);
    StoreWide(kLane, r->id);
    StoreWide(UintX16{}, r->flags);
}

/// Embree's form of the active lanes: all bits or none.
struct alignas(64) Valid {
    MaskX16 lanes;
    explicit Valid(LaneBits active) : lanes(MaskOf(active)) {}
    const int *Data() const { return reinterpret_cast<const int *>(&lanes); }
};

/// Lanes that ended at something, which Embree marks by a negative tfar.
LaneBits Ended(const RTCRay16 &r, LaneBits active) {
    return BitsOf(LoadWide(r.tfar) < 0) & active;
}

}  // namespace

LaneBits Accel::IntersectSingly(const RayPacket &rays, LaneBits active, HitPacket *hits) const {
    LaneBits found = 0;
    ForEachLane(active, [&](int i) {
        Hit hit;
        if (!Intersect(rays.At(i), &hit)) return;
        found |= 1u << i;
        hits->Set(i, hit);
    });
    return found;
}

LaneBits Accel::Intersect(const RayPacket &rays, LaneBits active, HitPacket *hits,
                          Coherence coherence) const {
    const bool coherent =
        coherence == Coherence::Alike || (coherence == Coherence::Octant && impl->IsSmall());
    if (!coherent && impl->IntersectsSingly()) return IntersectSingly(rays, active, hits);
    RTCRayHit16 rh;
    SetRays(rays, &rh.ray);
    StoreWide(UintX16{} + RTC_INVALID_GEOMETRY_ID, rh.hit.geomID);
    StoreWide(UintX16{} + RTC_INVALID_GEOMETRY_ID, rh.hit.instID[0]);
    QueryContext context(rays, nullptr, nullptr);
    Intersect16(impl->scene, &context.embree, Valid(active).Data(), &rh, coherent);

    UintX16 geometry = LoadWide(rh.hit.geomID), instance = LoadWide(rh.hit.instID[0]);
    const MaskX16 found = (geometry != RTC_INVALID_GEOMETRY_ID) & MaskOf(active);
    const MaskX16 instanced = found & (instance != RTC_INVALID_GEOMETRY_ID);
    instance -= instanced ? UintX16{} + impl->nTop : UintX16{};
    ForEachLane(BitsOf(instanced), [&](int i) {
        geometry[i] += impl->objects[impl->instances[instance[i]].object].first;
    });
    hits->t = Select(found, LoadWide(rh.ray.tfar), hits->t);
    hits->u = Select(found, LoadWide(rh.hit.u), hits->u);
    hits->v = Select(found, LoadWide(rh.hit.v), hits->v);
    hits->geometry = found ? geometry : hits->geometry;
    hits->primitive = found ? LoadWide(rh.hit.primID) : hits->primitive;
    hits->instance = found ? instance : hits->instance;
    return BitsOf(found);
}

LaneBits Accel::Occluded(const RayPacket &rays, LaneBits active) const {
    if (impl->OccludesSingly()) {
        LaneBits blocked = 0;
        ForEachLane(active, [&](int i) { blocked |= LaneBits(Occluded(rays.At(i))) << i; });
        return blocked;
    }
    RTCRay16 r;
    SetRays(rays, &r);
    QueryContext context(rays, nullptr, nullptr);
    Occluded16(impl->scene, &context.embree, Valid(active).Data(), &r);
    return Ended(r, active);
}

void Accel::Transmittance(const RayPacket &rays, LaneBits active, const NullTransmission &gaps,
                          FloatX16 *passed) const {
    if (impl->OccludesSingly())
        return ForEachLane(active, [&](int i) { (*passed)[i] = Transmittance(rays.At(i), gaps); });
    RTCRay16 r;
    SetRays(rays, &r);
    double product[kPacketSize];
    std::fill(product, product + kPacketSize, 1.);
    QueryContext context(rays, &gaps, product);
    Occluded16(impl->scene, &context.embree, Valid(active).Data(), &r);
    const LaneBits ended = Ended(r, active);
    ForEachLane(active, [&](int i) { (*passed)[i] = ended >> i & 1 ? 0 : float(product[i]); });
}

}  // namespace pbrt
