#include "pbrt/accel/curve_chords.h"

#include "pbrt/shapes/curve.h"

namespace pbrt {
namespace {

constexpr float kMaxDeviation = 0.25f;  ///< in radii
constexpr float kMaxTurn = 0.2f;        ///< radians

Vector3f SecondDerivative(const CurvePoint *c, float u) {
    const Vector3f from = c[0].p - 2.f * c[1].p + c[2].p, to = c[1].p - 2.f * c[2].p + c[3].p;
    return 6.f * Lerp(u, from, to);
}

/// End at u of a chord of length h in u. A chord between points of the curve lies inside its
/// bend by h^2 / 12 times the second derivative on average; this one is moved out by that.
CurvePoint ChordEnd(const CurvePoint *c, float u, float h) {
    const CurveAt at(c, u);
    return {at.p - (h * h / 12) * SecondDerivative(c, u), at.radius};
}

/// Whether one chord of length h from u on is less than CurveChords promises.
bool IsTooLong(const CurvePoint *c, float u, float h) {
    const CurveAt middle(c, u + h / 2);
    const float bend = std::max(Length(SecondDerivative(c, u)), Length(SecondDerivative(c, u + h)));
    return bend * h * h / 12 > kMaxDeviation * middle.radius ||
           bend * h > kMaxTurn * Length(middle.dpdu);
}

bool IsSame(const CurvePoint &a, const CurvePoint &b) {
    return a.p == b.p && a.radius == b.radius;
}

}  // namespace

CurveChords::CurveChords(const CurveSet &curves) {
    for (uint32_t i = 0; i < curves.first.size(); ++i)
        AddSegment(curves, i);
    points.shrink_to_fit();
    first.shrink_to_fit();
    parts.shrink_to_fit();
}

void CurveChords::AddSegment(const CurveSet &curves, uint32_t segment) {
    const size_t before = first.size();
    AddPart(&curves.points[curves.first[segment]], segment, 1);
    startsCurve.resize(first.size());
    startsCurve[before] = segment == 0 || curves.first[segment] != curves.first[segment - 1] + 3;
}

void CurveChords::AddPart(const CurvePoint *c, uint32_t segment, uint32_t part) {
    const uint32_t count = std::bit_floor(part);
    const float h = 1 / float(count), u = float(part - count) * h;
    if (count < kMostChords && IsTooLong(c, u, h)) {
        AddPart(c, segment, 2 * part);
        AddPart(c, segment, 2 * part + 1);
        return;
    }
    const CurvePoint from = ChordEnd(c, u, h);
    if (points.empty() || !IsSame(points.back(), from)) points.push_back(from);
    first.push_back(uint32_t(points.size() - 1));
    points.push_back(ChordEnd(c, u + h, h));
    parts.push_back(segment * kParts + part);
}

namespace {

/// Vector from a joint to the point where the ray passes it nearest.
Vector3f FromJoint(const RTCFilterFunctionNArguments *args, unsigned i, Point3f joint) {
    const unsigned n = args->N;
    RTCRayN *const r = args->ray;
    const Vector3f d{RTCRayN_dir_x(r, n, i), RTCRayN_dir_y(r, n, i), RTCRayN_dir_z(r, n, i)};
    const Point3f o{RTCRayN_org_x(r, n, i), RTCRayN_org_y(r, n, i), RTCRayN_org_z(r, n, i)};
    const Vector3f back = o - joint;
    return back - (Dot(back, d) / LengthSquared(d)) * d;
}

/// Whether the ray passes a joint, that of a chord and the one before, on the chord's side of it.
bool IsPast(const RTCFilterFunctionNArguments *args, unsigned i, const CurveChords &chords,
            uint32_t chord) {
    const CurvePoint *const before = &chords.Points()[chords.First()[chord - 1]];
    const CurvePoint *const after = &chords.Points()[chords.First()[chord]];
    const Vector3f halfWay =
        UnitOr(before[1].p - before[0].p, {}) + UnitOr(after[1].p - after[0].p, {});
    return Dot(FromJoint(args, i, after[0].p), halfWay) > 0;
}

/// Embree rounds a chord's ends off. That is cut off at a curve's ends, and between two chords
/// where each would reach into the other's half. What both cover counts once where they pass light,
/// for each crossing dims it.
bool IsOfRibbon(const RTCFilterFunctionNArguments *args, unsigned i, const CurveRecord &record,
                uint32_t chord, float along) {
    const CurveChords &chords = record.chords;
    if (along > 0 && along < 1 && !record.geometry->hasNullTransmission) return true;
    return (chords.IsFirst(chord) ? along > 0 : IsPast(args, i, chords, chord)) &&
           (chords.IsLast(chord) ? along < 1 : !IsPast(args, i, chords, chord + 1));
}

/// Drops hits beside the ribbon and makes those on it hits with the curve's segment.
void KeepRibbon(const RTCFilterFunctionNArguments *args, const CurveRecord &record) {
    const unsigned n = args->N;
    for (unsigned i = 0; i < n; ++i) {
        if (args->valid[i] == 0) continue;
        const float along = RTCHitN_u(args->hit, n, i);
        const uint32_t chord = RTCHitN_primID(args->hit, n, i);
        if (!IsOfRibbon(args, i, record, chord, along)) {
            args->valid[i] = 0;
            continue;
        }
        RTCHitN_u(args->hit, n, i) = record.chords.U(chord, along);
        RTCHitN_primID(args->hit, n, i) = record.chords.Segment(chord);
    }
}

const CurveRecord &RecordOf(const RTCFilterFunctionNArguments *args) {
    return static_cast<const CurveRecord &>(
        *static_cast<const GeometryRecord *>(args->geometryUserPtr));
}

void FilterCurveIntersection(const RTCFilterFunctionNArguments *args) {
    const CurveRecord &record = RecordOf(args);
    KeepRibbon(args, record);
    if (record.hasAlpha) FilterIntersection(args);
}

void FilterCurveOcclusion(const RTCFilterFunctionNArguments *args) {
    const CurveRecord &record = RecordOf(args);
    KeepRibbon(args, record);
    if (record.hasAlpha || record.geometry->hasNullTransmission) FilterOcclusion(args);
}

}  // namespace

/// Flat linear curves, for Embree takes twice as long with its flat Bezier curves, whose boxes it
/// has to turn (1.15 against 0.58 us a ray in a ball of 50 000 hairs).
RTCGeometry NewCurves(RTCDevice device, const CurveRecord *record) {
    const std::vector<CurvePoint> &points = record->chords.Points();
    const std::vector<uint32_t> &first = record->chords.First();
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, first.data(), 0,
                               sizeof(uint32_t), first.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                               points.data(), 0, sizeof(CurvePoint), points.size());
    const GeometryRecord *const common = record;
    rtcSetGeometryUserData(geometry, const_cast<GeometryRecord *>(common));
    rtcSetGeometryIntersectFilterFunction(geometry, FilterCurveIntersection);
    rtcSetGeometryOccludedFilterFunction(geometry, FilterCurveOcclusion);
    return geometry;
}

}  // namespace pbrt
