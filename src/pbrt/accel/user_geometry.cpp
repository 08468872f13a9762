#include "pbrt/accel/user_geometry.h"

#include <algorithm>

namespace pbrt {
namespace {

/// A primitive of either kind: its record and its crossings.
struct PlacedPrimitive {
    const PlacedRecord &placed;

    PlacedPrimitive(const void *set, unsigned i)
        : placed((*static_cast<const PlacedSet *>(set))[i]) {}
    const GeometryRecord &Record() const { return placed.common; }
    uint32_t Index(unsigned) const { return 0; }
    RayD ToObject(const Ray &ray) const {
        return {placed.objectFromRender->Point(ToDouble(ray.o)),
                placed.objectFromRender->Vector(ToDouble(ray.d)), 0, ray.tMax};
    }
    std::optional<PrimitiveHit> Intersect(const RayD &ray) const {
        return Dispatch(placed.common.geometry->shape,
                        [&]<typename S>(const S &s) -> std::optional<PrimitiveHit> {
                            if constexpr (S::kTraits.hasObjectSpace) return s.Intersect(0, ray);
                            return {};
                        });
    }
};

template <typename S>
struct MeshPrimitive {
    const GeometryRecord &record;
    const S &shape;
    uint32_t index;

    MeshPrimitive(const void *user, unsigned i)
        : record(*static_cast<const GeometryRecord *>(user)),
          shape(*std::get_if<S>(&record.geometry->shape)),
          index(i) {}
    const GeometryRecord &Record() const { return record; }
    uint32_t Index(unsigned primitive) const { return primitive; }
    RayD ToObject(const Ray &ray) const { return {ToDouble(ray.o), ToDouble(ray.d), 0, ray.tMax}; }
    std::optional<PrimitiveHit> Intersect(const RayD &ray) const {
        return shape.Intersect(index, ray);
    }
};

Ray RayOf(RTCRayN *r, unsigned n, unsigned i) {
    return {{RTCRayN_org_x(r, n, i), RTCRayN_org_y(r, n, i), RTCRayN_org_z(r, n, i)},
            {RTCRayN_dir_x(r, n, i), RTCRayN_dir_y(r, n, i), RTCRayN_dir_z(r, n, i)},
            RTCRayN_tfar(r, n, i),
            RTCRayN_time(r, n, i)};
}

/// The first crossing that `keep(hit, crossing)` takes.
template <typename Primitive, typename F>
std::optional<Hit> FirstKept(const Primitive &primitive, uint32_t index, const Ray &ray,
                             const EmbreeContext &context, F keep) {
    RayD local = primitive.ToObject(ray);
    for (int crossing = 0;; ++crossing) {
        const std::optional<PrimitiveHit> met = primitive.Intersect(local);
        if (!met) return {};
        const Hit hit =
            primitive.Record().ToHit(float(met->t), float(met->u), float(met->v), index, context);
        if (keep(hit, crossing)) return hit;
        local.tMin = met->t;
    }
}

template <typename Primitive>
void IntersectUser(const RTCIntersectFunctionNArguments *args) {
    const unsigned n = args->N;
    RTCRayN *const r = RTCRayHitN_RayN(args->rayhit, n);
    RTCHitN *const h = RTCRayHitN_HitN(args->rayhit, n);
    const Primitive primitive(args->geometryUserPtr, args->primID);
    const GeometryRecord &record = primitive.Record();
    const QueryContext &context = QueryContext::Of(args->context);
    for (unsigned i = 0; i < n; ++i) {
        if (args->valid[i] == 0) continue;
        const Ray ray = RayOf(r, n, i);
        const auto hit = FirstKept(
            primitive, primitive.Index(args->primID), ray, context.embree,
            [&](const Hit &hit, int crossing) {
                return !record.hasAlpha ||
                       !IsCutOut(record, hit, ray, context.WorldRay(RTCRayN_id(r, n, i)), crossing);
            });
        if (!hit) continue;
        RTCRayN_tfar(r, n, i) = hit->t;
        RTCHitN_u(h, n, i) = hit->u;
        RTCHitN_v(h, n, i) = hit->v;
        RTCHitN_primID(h, n, i) = hit->primitive;
        RTCHitN_geomID(h, n, i) = record.local;
        RTCHitN_instID(h, n, i, 0) = context.embree.instID[0];
    }
}

template <typename Primitive>
void OccludedUser(const RTCOccludedFunctionNArguments *args) {
    const unsigned n = args->N;
    const Primitive primitive(args->geometryUserPtr, args->primID);
    const GeometryRecord &record = primitive.Record();
    QueryContext &context = QueryContext::Of(args->context);
    for (unsigned i = 0; i < n; ++i) {
        if (args->valid[i] == 0) continue;
        const Ray ray = RayOf(args->ray, n, i);
        const auto hit = FirstKept(primitive, primitive.Index(args->primID), ray, context.embree,
                                   [&](const Hit &hit, int crossing) {
                                       return Blocks(record, hit, ray, context,
                                                     RTCRayN_id(args->ray, n, i), crossing);
                                   });
        if (hit) RTCRayN_tfar(args->ray, n, i) = -Infinity;
    }
}

void IntersectPlaced(const RTCIntersectFunctionNArguments *args) {
    const PlacedRecord &placed = PlacedPrimitive(args->geometryUserPtr, args->primID).placed;
    if (placed.ball)
        IntersectBall(*placed.ball, placed.common.local, args);
    else
        IntersectUser<PlacedPrimitive>(args);
}

void OccludedPlaced(const RTCOccludedFunctionNArguments *args) {
    const PlacedRecord &placed = PlacedPrimitive(args->geometryUserPtr, args->primID).placed;
    const bool mayPass =
        placed.common.geometry->hasNullTransmission && QueryContext::Of(args->context).gaps;
    if (placed.ball && !mayPass)
        OccludedBall(*placed.ball, args);
    else
        OccludedUser<PlacedPrimitive>(args);
}

void PlacedBounds(const RTCBoundsFunctionArguments *args) {
    const auto &set = *static_cast<const PlacedSet *>(args->geometryUserPtr);
    SetBounds(Bounds(set[args->primID].common.geometry->shape), args->bounds_o);
}

template <typename S>
void MeshBounds(const RTCBoundsFunctionArguments *args) {
    const MeshPrimitive<S> primitive(args->geometryUserPtr, args->primID);
    SetBounds(primitive.shape.PrimitiveBounds(primitive.index), args->bounds_o);
}

}  // namespace

void SetBounds(const Bounds3f &b, RTCBounds *out) {
    out->lower_x = b.min.x, out->lower_y = b.min.y, out->lower_z = b.min.z;
    out->upper_x = b.max.x, out->upper_y = b.max.y, out->upper_z = b.max.z;
}

RTCGeometry NewByCallbacks(RTCDevice device, const void *user, size_t count,
                           RTCBoundsFunction bounds, RTCIntersectFunctionN intersect,
                           RTCOccludedFunctionN occluded) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(count));
    rtcSetGeometryUserData(geometry, const_cast<void *>(user));
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    return geometry;
}

PlacedRecord::PlacedRecord(const GeometryRecord &record, const Transform &renderFromObject)
    : common(record),
      ball(record.hasAlpha ? std::nullopt : WorldSphere::Of(record.geometry->shape)) {
    if (!ball || record.geometry->hasNullTransmission)
        objectFromRender = std::make_unique<ObjectFromRender>(renderFromObject);
}

RTCGeometry NewPlaced(RTCDevice device, const PlacedSet *set) {
    return NewByCallbacks(device, set, set->size(), PlacedBounds, IntersectPlaced, OccludedPlaced);
}

RTCGeometry NewUserGeometry(RTCDevice device, const GeometryRecord *record) {
    return Dispatch(record->geometry->shape, [&]<typename S>(const S &shape) -> RTCGeometry {
        if constexpr (S::kTraits.intersectsItself && !S::kTraits.hasObjectSpace)
            return NewByCallbacks(device, record, shape.NPrimitives(), MeshBounds<S>,
                                  IntersectUser<MeshPrimitive<S>>, OccludedUser<MeshPrimitive<S>>);
        return nullptr;
    });
}

}  // namespace pbrt
