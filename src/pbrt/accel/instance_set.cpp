#include "pbrt/accel/instance_set.h"

#include <bit>

#include "pbrt/accel/user_geometry.h"
#include "pbrt/shapes/rounding.h"

namespace pbrt {
namespace {

/// One instance in the callbacks.
class Placed {
  public:
    Placed(const void *user, unsigned primitive)
        : set(*static_cast<const InstanceSet *>(user)), index(set.resting[primitive]) {}

    RTCScene Object() const { return set.objects[TheInstance().object]; }
    /// As hits name it.
    uint32_t Id() const { return set.firstId + index; }
    const Instance &TheInstance() const { return set.instances[index]; }

    /// Ray i of a packet of n, in the object's space.
    void TakeRay(RTCRayN *rays, unsigned n, unsigned i, RTCRay *to) const {
        const AffineTransform &t = TheInstance().renderFromObject;
        const Point3f o = t.InversePoint(Point3f{
            RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)});
        const Vector3f d = t.InverseVector(Vector3f{
            RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)});
        to->org_x = o.x, to->org_y = o.y, to->org_z = o.z;
        to->dir_x = d.x, to->dir_y = d.y, to->dir_z = d.z;
        to->tnear = RTCRayN_tnear(rays, n, i);
        to->tfar = RTCRayN_tfar(rays, n, i);
        to->time = RTCRayN_time(rays, n, i);
        to->mask = RTCRayN_mask(rays, n, i);
        to->id = RTCRayN_id(rays, n, i);
        to->flags = RTCRayN_flags(rays, n, i);
    }

    /// The same for all of a packet of sixteen.
    void TakeRays(const RTCRay16 &rays, RTCRay16 *to) const {
        const AffineTransform &t = TheInstance().renderFromObject;
        const Point3fX16 o = t.InversePoint(
            Point3fX16{LoadX16(rays.org_x), LoadX16(rays.org_y), LoadX16(rays.org_z)});
        const Vector3fX16 d = t.InverseVector(
            Vector3fX16{LoadX16(rays.dir_x), LoadX16(rays.dir_y), LoadX16(rays.dir_z)});
        *to = rays;
        Store(o.x, to->org_x), Store(o.y, to->org_y), Store(o.z, to->org_z);
        Store(d.x, to->dir_x), Store(d.y, to->dir_y), Store(d.z, to->dir_z);
    }

  private:
    const InstanceSet &set;
    uint32_t index;
};

/// Says to hits and callbacks in which instance they are.
class Inside {
  public:
    Inside(EmbreeContext *context, uint32_t id) : context(context) { context->instID[0] = id; }
    ~Inside() { context->instID[0] = RTC_INVALID_GEOMETRY_ID; }
    Inside(const Inside &) = delete;
    Inside &operator=(const Inside &) = delete;

  private:
    EmbreeContext *context;
};

void IntersectRay(const Placed &placed, const RTCIntersectFunctionNArguments *args, unsigned i) {
    const unsigned n = args->N;
    RTCRayN *const rays = RTCRayHitN_RayN(args->rayhit, n);
    RTCRayHit local;
    placed.TakeRay(rays, n, i, &local.ray);
    local.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    Intersect1(placed.Object(), args->context, &local);
    if (local.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    RTCHitN *const hits = RTCRayHitN_HitN(args->rayhit, n);
    RTCRayN_tfar(rays, n, i) = local.ray.tfar;
    RTCHitN_u(hits, n, i) = local.hit.u;
    RTCHitN_v(hits, n, i) = local.hit.v;
    RTCHitN_primID(hits, n, i) = local.hit.primID;
    RTCHitN_geomID(hits, n, i) = local.hit.geomID;
    RTCHitN_instID(hits, n, i, 0) = placed.Id();
}

void IntersectPacket(const Placed &placed, const RTCIntersectFunctionNArguments *args) {
    auto &packet = *reinterpret_cast<RTCRayHit16 *>(args->rayhit);
    RTCRayHit16 local;
    placed.TakeRays(packet.ray, &local.ray);
    Store(UintX16(RTC_INVALID_GEOMETRY_ID), local.hit.geomID);
    Intersect16(placed.Object(), args->context, args->valid, &local, false);
    const MaskX16 met =
        (LoadX16(args->valid) != 0) & (LoadX16(local.hit.geomID) != RTC_INVALID_GEOMETRY_ID);
    const auto take = [met](const auto *from, auto *to) {
        Store(Select(met, LoadX16(from), LoadX16(to)), to);
    };
    take(local.ray.tfar, packet.ray.tfar);
    take(local.hit.u, packet.hit.u);
    take(local.hit.v, packet.hit.v);
    take(local.hit.primID, packet.hit.primID);
    take(local.hit.geomID, packet.hit.geomID);
    Store(Select(met, UintX16(placed.Id()), LoadX16(packet.hit.instID[0])), packet.hit.instID[0]);
}

void OccludeRay(const Placed &placed, const RTCOccludedFunctionNArguments *args, unsigned i) {
    RTCRay local;
    placed.TakeRay(args->ray, args->N, i, &local);
    Occluded1(placed.Object(), args->context, &local);
    if (local.tfar < 0) RTCRayN_tfar(args->ray, args->N, i) = -Infinity;
}

void OccludePacket(const Placed &placed, const RTCOccludedFunctionNArguments *args) {
    auto &packet = *reinterpret_cast<RTCRay16 *>(args->ray);
    RTCRay16 local;
    placed.TakeRays(packet, &local);
    Occluded16(placed.Object(), args->context, args->valid, &local);
    const MaskX16 met = (LoadX16(args->valid) != 0) & (LoadX16(local.tfar) < 0);
    Store(Select(met, -Infinity, LoadX16(packet.tfar)), packet.tfar);
}

/// Calls one(placed, args, i) for each ray that is wanted, or many(placed, args) for a packet of
/// sixteen with more than one of them.
template <typename Args, typename One, typename Many>
void ForRays(const Args *args, One one, Many many) {
    const Placed placed(args->geometryUserPtr, args->primID);
    const Inside inside(args->context, placed.Id());
    if (args->N == kPacketSize && !std::has_single_bit(BitsOf(LoadX16(args->valid) != 0)))
        return many(placed, args);
    for (unsigned i = 0; i < args->N; ++i)
        if (args->valid[i] != 0) one(placed, args, i);
}

void IntersectInstance(const RTCIntersectFunctionNArguments *args) {
    ForRays(args, IntersectRay, IntersectPacket);
}

void OccludeInstance(const RTCOccludedFunctionNArguments *args) {
    ForRays(args, OccludeRay, OccludePacket);
}

/// The object's bounds, moved, and wider by the roundings of that.
void InstanceBounds(const RTCBoundsFunctionArguments *args) {
    const Placed placed(args->geometryUserPtr, args->primID);
    RTCBounds b;
    rtcGetSceneBounds(placed.Object(), &b);
    const Bounds3f object{{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
    const Vector3f farthest = Max(Abs(Vector3f(object.min)), Abs(Vector3f(object.max)));
    const Transform renderFromObject = placed.TheInstance().Key(0);
    const Vector3f rounding = Gamma(4) * AbsPoint(renderFromObject.Matrix(), farthest);
    Bounds3f moved = renderFromObject.Bounds(object);
    moved.min = moved.min - rounding;
    moved.max = moved.max + rounding;
    SetBounds(moved, args->bounds_o);
}

}  // namespace

RTCGeometry NewInstances(RTCDevice device, const InstanceSet *set) {
    return NewByCallbacks(device, set, set->resting.size(), InstanceBounds, IntersectInstance,
                          OccludeInstance);
}

}  // namespace pbrt
