#include "pbrt/accel/user_geometry.h"

#include <algorithm>

namespace pbrt {
namespace {

struct UserHit {
    double t;
    float u, v;
};

/// A primitive of either kind: its record and its crossings.
struct QuadricPrimitive {
    const QuadricRecord &quadric;

    QuadricPrimitive(const void *set, unsigned i)
        : quadric((*static_cast<const QuadricSet *>(set))[i]) {}
    const GeometryRecord &Record() const { return quadric.common; }
    uint32_t Index(unsigned) const { return 0; }
    RayD ToObject(const Ray &ray) const {
        return {quadric.objectFromRender->Point(ToDouble(ray.o)),
                quadric.objectFromRender->Vector(ToDouble(ray.d)), 0, ray.tMax};
    }
    std::optional<UserHit> Intersect(const RayD &ray) const {
        const Shape &shape = quadric.common.geometry->shape;
        std::optional<double> t;
        if (const auto *s = std::get_if<Sphere>(&shape))
            t = IntersectQuadric(*s, ray);
        else if (const auto *c = std::get_if<Cylinder>(&shape))
            t = IntersectQuadric(*c, ray);
        else
            t = IntersectQuadric(*std::get_if<Disk>(&shape), ray);
        if (!t) return {};
        return UserHit{*t, 0, 0};
    }
};

struct PatchPrimitive {
    const GeometryRecord &record;
    Patch patch;

    PatchPrimitive(const void *user, unsigned i)
        : record(*static_cast<const GeometryRecord *>(user)),
          patch(GetPatch(*std::get_if<BilinearMesh>(&record.geometry->shape), i)) {}
    const GeometryRecord &Record() const { return record; }
    uint32_t Index(unsigned primitive) const { return primitive; }
    RayD ToObject(const Ray &ray) const { return {ToDouble(ray.o), ToDouble(ray.d), 0, ray.tMax}; }
    std::optional<UserHit> Intersect(const RayD &ray) const {
        const auto hit = IntersectPatch(patch, ray);
        if (!hit) return {};
        return UserHit{hit->t, float(hit->u), float(hit->v)};
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
        const std::optional<UserHit> met = primitive.Intersect(local);
        if (!met) return {};
        const Hit hit = primitive.Record().ToHit(float(met->t), met->u, met->v, index, context);
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

void IntersectQuadrics(const RTCIntersectFunctionNArguments *args) {
    const QuadricRecord &quadric = QuadricPrimitive(args->geometryUserPtr, args->primID).quadric;
    if (quadric.ball)
        IntersectBall(*quadric.ball, quadric.common.local, args);
    else
        IntersectUser<QuadricPrimitive>(args);
}

void OccludedQuadrics(const RTCOccludedFunctionNArguments *args) {
    const QuadricRecord &quadric = QuadricPrimitive(args->geometryUserPtr, args->primID).quadric;
    const bool mayPass =
        quadric.common.geometry->hasNullTransmission && QueryContext::Of(args->context).gaps;
    if (quadric.ball && !mayPass)
        OccludedBall(*quadric.ball, args);
    else
        OccludedUser<QuadricPrimitive>(args);
}

void SetBounds(const Bounds3f &b, RTCBounds *out) {
    out->lower_x = b.min.x, out->lower_y = b.min.y, out->lower_z = b.min.z;
    out->upper_x = b.max.x, out->upper_y = b.max.y, out->upper_z = b.max.z;
}

void QuadricBounds(const RTCBoundsFunctionArguments *args) {
    const auto &set = *static_cast<const QuadricSet *>(args->geometryUserPtr);
    SetBounds(Bounds(set[args->primID].common.geometry->shape), args->bounds_o);
}

void PatchBounds(const RTCBoundsFunctionArguments *args) {
    const Patch q = PatchPrimitive(args->geometryUserPtr, args->primID).patch;
    Bounds3f b;
    for (const Point3f &p : {q.p00, q.p10, q.p01, q.p11})
        b.Grow(p);
    SetBounds(b, args->bounds_o);
}

RTCGeometry NewUserGeometry(RTCDevice device, const void *user, size_t count,
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

}  // namespace

QuadricRecord::QuadricRecord(const GeometryRecord &record, const Transform &renderFromObject)
    : common(record),
      ball(record.hasAlpha ? std::nullopt : WorldSphere::Of(record.geometry->shape)) {
    if (!ball || record.geometry->hasNullTransmission)
        objectFromRender = std::make_unique<ObjectFromRender>(renderFromObject);
}

RTCGeometry NewQuadrics(RTCDevice device, const QuadricSet *quadrics) {
    return NewUserGeometry(device, quadrics, quadrics->size(), QuadricBounds, IntersectQuadrics,
                           OccludedQuadrics);
}

RTCGeometry NewBentPatches(RTCDevice device, const GeometryRecord *record) {
    return NewUserGeometry(device, record, NPrimitives(record->geometry->shape), PatchBounds,
                           IntersectUser<PatchPrimitive>, OccludedUser<PatchPrimitive>);
}

}  // namespace pbrt
