// Shapes that Embree traces by itself. Ribbons are not among them (shapes/curve.cpp makes triangles
// of them), for Embree 3.13's oriented curves miss one ray in eight that should meet them.

#include "pbrt/accel/impl.h"

namespace pbrt {
namespace {

/// Shares the points with Embree, which reads 16 bytes for each; a copy where the vector does not
/// own the 4 bytes behind the last one.
void SetPoints(RTCGeometry geometry, const std::vector<Point3f> &p) {
    if (p.capacity() > p.size()) {
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, p.data(),
                                   0, sizeof(Point3f), p.size());
        return;
    }
    void *const copy = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                               RTC_FORMAT_FLOAT3, sizeof(Point3f), p.size());
    if (copy) std::copy(p.begin(), p.end(), static_cast<Point3f *>(copy));
}

RTCGeometry NewTriangles(RTCDevice device, const TriangleMesh &mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.indices.data(), 0, 3 * sizeof(uint32_t), mesh.NPrimitives());
    SetPoints(geometry, mesh.p);
    return geometry;
}

/// Embree counts a quad's corners round the edge, 00 10 11 01.
RTCGeometry NewQuads(RTCDevice device, const BilinearMesh &mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    SetPoints(geometry, mesh.p);
    auto *const corners = static_cast<uint32_t *>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                                4 * sizeof(uint32_t), mesh.NPrimitives()));
    for (size_t i = 0; corners && i < mesh.indices.size(); i += 4) {
        corners[i] = mesh.indices[i];
        corners[i + 1] = mesh.indices[i + 1];
        corners[i + 2] = mesh.indices[i + 3];
        corners[i + 3] = mesh.indices[i + 2];
    }
    return geometry;
}

/// The record, and filters where hits may not count.
void SetRecord(RTCGeometry geometry, const GeometryRecord &record) {
    rtcSetGeometryUserData(geometry, const_cast<GeometryRecord *>(&record));
    if (record.hasAlpha) rtcSetGeometryIntersectFilterFunction(geometry, FilterIntersection);
    if (record.hasAlpha || record.geometry->hasNullTransmission)
        rtcSetGeometryOccludedFilterFunction(geometry, FilterOcclusion);
}

}  // namespace

RTCGeometry Accel::Impl::NewNative(const GeometryRecord &record, const TriangleMesh &mesh) {
    RTCGeometry geometry = NewTriangles(device, mesh);
    SetRecord(geometry, record);
    return geometry;
}

RTCGeometry Accel::Impl::NewNative(const GeometryRecord &record, const BilinearMesh &mesh) {
    RTCGeometry geometry = NewQuads(device, mesh);
    SetRecord(geometry, record);
    return geometry;
}

RTCGeometry Accel::Impl::NewNative(const GeometryRecord &record, const CurveSet &set) {
    curves.push_back({record, CurveChords(set)});
    memory.Add(int64_t(curves.back().chords.Bytes()));
    return NewCurves(device, &curves.back());
}

bool IsNative(const Shape &shape) {
    return Dispatch(shape, [](const auto &s) { return IsNative(s); });
}

RTCGeometry Accel::Impl::NewGeometry(const GeometryRecord &record) {
    return Dispatch(record.geometry->shape, [&]<typename S>(const S &s) {
        if constexpr (kMayBeNative<S>)
            if (IsNative(s)) return NewNative(record, s);
        return NewUserGeometry(device, &record);
    });
}

}  // namespace pbrt
