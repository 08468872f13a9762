#include <limits>

#include "pbrt/accel/impl.h"

namespace pbrt {
namespace {

void SetRays(const RayPacket &rays, RTCRay16 *r) {
    Store(rays.o.x, r->org_x);
    Store(rays.o.y, r->org_y);
    Store(rays.o.z, r->org_z);
    Store(FloatX16(std::numeric_limits<float>::min()), r->tnear);
    Store(rays.d.x, r->dir_x);
    Store(rays.d.y, r->dir_y);
    Store(rays.d.z, r->dir_z);
    Store(rays.time, r->time);
    Store(rays.tMax, r->tfar);
    Store(UintX16(~0u), r->mask);
    Store(kLaneNumbers, r->id);
    Store(UintX16{}, r->flags);
}

/// Embree's form of the active lanes: all bits or none.
struct alignas(64) Valid {
    int32_t lanes[kPacketSize];
    explicit Valid(LaneBits active) { MaskOf(active).Store(lanes); }
};

/// Lanes that ended at something, which Embree marks by a negative tfar.
LaneBits Ended(const RTCRay16 &r, LaneBits active) {
    return BitsOf(LoadX16(r.tfar) < 0) & active;
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
    Store(UintX16(RTC_INVALID_GEOMETRY_ID), rh.hit.geomID);
    Store(UintX16(RTC_INVALID_GEOMETRY_ID), rh.hit.instID[0]);
    QueryContext context(rays, nullptr, nullptr);
    Intersect16(impl->scene, &context.embree, Valid(active).lanes, &rh, coherent);

    UintX16 geometry = LoadX16(rh.hit.geomID), instance = LoadX16(rh.hit.instID[0]);
    const MaskX16 found = (geometry != RTC_INVALID_GEOMETRY_ID) & MaskOf(active);
    const MaskX16 instanced = found & (instance != RTC_INVALID_GEOMETRY_ID);
    instance -= Select(instanced, impl->nTop, 0u);
    ForEachLane(BitsOf(instanced), [&](int i) {
        geometry.Set(i, geometry[i] + impl->objects[impl->instances[instance[i]].object].first);
    });
    hits->t = Select(found, LoadX16(rh.ray.tfar), hits->t);
    hits->u = Select(found, LoadX16(rh.hit.u), hits->u);
    hits->v = Select(found, LoadX16(rh.hit.v), hits->v);
    hits->geometry = Select(found, geometry, hits->geometry);
    hits->primitive = Select(found, LoadX16(rh.hit.primID), hits->primitive);
    hits->instance = Select(found, instance, hits->instance);
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
    Occluded16(impl->scene, &context.embree, Valid(active).lanes, &r);
    return Ended(r, active);
}

void Accel::Transmittance(const RayPacket &rays, LaneBits active, const NullTransmission &gaps,
                          FloatX16 *passed) const {
    if (impl->OccludesSingly())
        return ForEachLane(active, [&](int i) { passed->Set(i, Transmittance(rays.At(i), gaps)); });
    RTCRay16 r;
    SetRays(rays, &r);
    double product[kPacketSize];
    std::fill(product, product + kPacketSize, 1.);
    QueryContext context(rays, &gaps, product);
    Occluded16(impl->scene, &context.embree, Valid(active).lanes, &r);
    const LaneBits ended = Ended(r, active);
    ForEachLane(active, [&](int i) { passed->Set(i, ended >> i & 1 ? 0 : float(product[i])); });
}

}  // namespace pbrt
