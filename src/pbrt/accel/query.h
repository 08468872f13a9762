#pragma once

#include "pbrt/accel/accel.h"
#include "pbrt/accel/embree_api.h"
#include "pbrt/base/hit.h"

namespace pbrt {

/// Travels with each query through Embree to the callbacks. A ray's id is its lane, 0 for a single
/// one.
struct QueryContext {
    EmbreeContext embree;  ///< first: Embree hands back its address
    const Ray *single;     ///< null: a packet
    const RayPacket *packet;
    const NullTransmission *gaps;  ///< null: surfaces with gaps are opaque
    /// Product of gap fractions by ray id; in double, so that its order hardly matters.
    double *passed;

    QueryContext(const Ray &ray, const NullTransmission *gaps, double *passed)
        : single(&ray), packet(nullptr), gaps(gaps), passed(passed) {
        InitContext(&embree);
    }
    QueryContext(const RayPacket &rays, const NullTransmission *gaps, double *passed)
        : single(nullptr), packet(&rays), gaps(gaps), passed(passed) {
        InitContext(&embree);
    }
    Ray WorldRay(unsigned id) const { return single ? *single : packet->At(int(id)); }
    static QueryContext &Of(EmbreeContext *context) {
        return *reinterpret_cast<QueryContext *>(context);
    }
};

/// A geometry's data for the callbacks.
struct GeometryRecord {
    const Geometry *geometry;
    uint32_t index;          ///< in RenderScene::geometries
    uint32_t local;          ///< Embree's geometry ID within its scene
    uint32_t firstInstance;  ///< Embree's ID of instance 0
    bool hasAlpha;

    Hit ToHit(float t, float u, float v, uint32_t primitive, const EmbreeContext &context) const {
        const uint32_t id = context.instID[0];
        return {t,     u,         v,
                index, primitive, id == RTC_INVALID_GEOMETRY_ID ? ~0u : id - firstInstance};
    }
};

/// True where alpha cuts the surface away at a hit. `ray` is in the geometry's space, `worldRay` as
/// the query had it; `crossing` counts hits of one ray with one primitive.
bool IsCutOut(const GeometryRecord &record, const Hit &hit, const Ray &ray, const Ray &worldRay,
              int crossing);

/// True where a shadow ray ends at the hit; if not, notes the share that passes.
bool Blocks(const GeometryRecord &record, const Hit &hit, const Ray &ray, QueryContext &context,
            unsigned id, int crossing);

// Embree's filters for geometries with alpha or gaps; user data: GeometryRecord.
void FilterIntersection(const RTCFilterFunctionNArguments *args);
void FilterOcclusion(const RTCFilterFunctionNArguments *args);

}  // namespace pbrt
