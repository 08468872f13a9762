#include "pbrt/accel/query.h"
#include "pbrt/util/hash.h"

namespace pbrt {

bool IsCutOut(const GeometryRecord &record, const Hit &hit, const Ray &ray, const Ray &worldRay,
              int crossing) {
    const FloatTexture &texture = record.geometry->alpha;
    float alpha;
    if (texture.IsConstant()) {
        alpha = texture.Constant();
    } else {
        const SurfaceInteraction s = SurfaceAtWithoutError(record.geometry->shape, hit, ray);
        TextureEvalContext at;
        at.p = worldRay(hit.t);
        at.n = s.n;
        at.uv = s.uv;
        at.faceIndex = s.faceIndex;
        alpha = texture.Evaluate(at);
    }
    if (alpha >= 1) return false;
    if (alpha <= 0) return true;
    return HashFloat(worldRay.o, worldRay.d, hit.geometry, hit.primitive, hit.instance, crossing) >=
           alpha;
}

bool Blocks(const GeometryRecord &record, const Hit &hit, const Ray &ray, QueryContext &context,
            unsigned id, int crossing) {
    const Ray worldRay = context.WorldRay(id);
    if (record.hasAlpha && IsCutOut(record, hit, ray, worldRay, crossing)) return false;
    if (!record.geometry->hasNullTransmission || !context.gaps) return true;
    double &passed = context.passed[id];
    passed *= (*context.gaps)(hit, worldRay);
    return passed == 0;
}

namespace {

/// The i-th of a filter's candidates, in the geometry's space.
struct Candidate {
    const GeometryRecord &record;
    QueryContext &context;
    Ray ray;
    Hit hit;
    unsigned id;

    Candidate(const RTCFilterFunctionNArguments *args, unsigned i)
        : record(*static_cast<const GeometryRecord *>(args->geometryUserPtr)),
          context(QueryContext::Of(args->context)) {
        const unsigned n = args->N;
        RTCRayN *const r = args->ray;
        RTCHitN *const h = args->hit;
        ray.o = {RTCRayN_org_x(r, n, i), RTCRayN_org_y(r, n, i), RTCRayN_org_z(r, n, i)};
        ray.d = {RTCRayN_dir_x(r, n, i), RTCRayN_dir_y(r, n, i), RTCRayN_dir_z(r, n, i)};
        ray.tMax = RTCRayN_tfar(r, n, i);
        ray.time = RTCRayN_time(r, n, i);
        id = RTCRayN_id(r, n, i);
        hit = record.ToHit(ray.tMax, RTCHitN_u(h, n, i), RTCHitN_v(h, n, i),
                           RTCHitN_primID(h, n, i), context.embree);
    }
};

}  // namespace

void FilterIntersection(const RTCFilterFunctionNArguments *args) {
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const Candidate c(args, i);
        if (IsCutOut(c.record, c.hit, c.ray, c.context.WorldRay(c.id), 0)) args->valid[i] = 0;
    }
}

void FilterOcclusion(const RTCFilterFunctionNArguments *args) {
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const Candidate c(args, i);
        if (!Blocks(c.record, c.hit, c.ray, c.context, c.id, 0)) args->valid[i] = 0;
    }
}

}  // namespace pbrt
