#include <limits>

#include "pbrt/accel/impl.h"

namespace pbrt {
namespace {

void SetRay(const Ray &ray, RTCRay *r) {
    r->org_x = ray.o.x, r->org_y = ray.o.y, r->org_z = ray.o.z;
    // Not 0: Embree counts a hit at tnear, and a ray may start exactly in a triangle's plane.
    r->tnear = std::numeric_limits<float>::min();
    r->dir_x = ray.d.x, r->dir_y = ray.d.y, r->dir_z = ray.d.z;
    r->time = ray.time;
    r->tfar = ray.tMax;
    r->mask = ~0u;
    r->id = 0;
    r->flags = 0;
}

}  // namespace

bool Accel::Intersect(const Ray &ray, Hit *hit) const {
    RTCRayHit rh;
    SetRay(ray, &rh.ray);
    rh.hit.geomID = rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    QueryContext context(ray, nullptr, nullptr);
    Intersect1(impl->scene, &context.embree, &rh);
    if (rh.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    *hit = {rh.ray.tfar, rh.hit.u, rh.hit.v, rh.hit.geomID, rh.hit.primID, ~0u};
    if (rh.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
        hit->instance = rh.hit.instID[0] - impl->nTop;
        hit->geometry += impl->objects[impl->instances[hit->instance].object].first;
    }
    return true;
}

bool Accel::Occluded(const Ray &ray) const {
    RTCRay r;
    SetRay(ray, &r);
    QueryContext context(ray, nullptr, nullptr);
    Occluded1(impl->scene, &context.embree, &r);
    return r.tfar < 0;
}

float Accel::Transmittance(const Ray &ray, const NullTransmission &gaps) const {
    RTCRay r;
    SetRay(ray, &r);
    double passed = 1;
    QueryContext context(ray, &gaps, &passed);
    Occluded1(impl->scene, &context.embree, &r);
    return r.tfar < 0 ? 0 : float(passed);
}

}  // namespace pbrt
