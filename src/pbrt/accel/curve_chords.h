#pragma once

#include <vector>

#include "pbrt/accel/query.h"

namespace pbrt {

/// Straight pieces that stand for curves in traversal, each as wide as the curve there. An axis
/// leaves the curve's by at most a quarter of its radius, half that on average, to both sides
/// alike, and from chord to chord the direction turns by at most 0.2 (or what a sixteenth of a
/// segment gives, if that is more).
class CurveChords {
  public:
    explicit CurveChords(const CurveSet &curves);

    /// Embree's buffers: chord i runs from Points()[First()[i]] to the next point.
    const std::vector<CurvePoint> &Points() const { return points; }
    const std::vector<uint32_t> &First() const { return first; }

    /// The segment that a chord is a part of.
    uint32_t Segment(uint32_t chord) const { return parts[chord] / kParts; }
    /// The segment's u at `along` the chord, in [0, 1].
    float U(uint32_t chord, float along) const {
        const uint32_t part = parts[chord] % kParts, count = std::bit_floor(part);
        return (float(part - count) + along) / float(count);
    }
    // Whether the curve starts, ends with this chord.
    bool IsFirst(uint32_t chord) const { return startsCurve[chord]; }
    bool IsLast(uint32_t chord) const {
        return chord + 1 == first.size() || startsCurve[chord + 1];
    }
    size_t Bytes() const {
        return points.capacity() * sizeof(CurvePoint) +
               (first.capacity() + parts.capacity()) * sizeof(uint32_t) + startsCurve.size() / 8;
    }

  private:
    static constexpr uint32_t kMostChords = 16, kParts = 2 * kMostChords;
    static_assert(kMaxCurveSegments <= (uint64_t(1) << 32) / kParts);

    void AddSegment(const CurveSet &curves, uint32_t segment);
    void AddPart(const CurvePoint *c, uint32_t segment, uint32_t part);

    std::vector<CurvePoint> points;
    std::vector<uint32_t> first;
    /// Segment * kParts + part. Parts are numbered as a binary tree's nodes: 1 is the whole, 2 and
    /// 3 are its halves.
    std::vector<uint32_t> parts;
    std::vector<bool> startsCurve;
};

struct CurveRecord : GeometryRecord {
    CurveChords chords;
};

/// Makes the Embree geometry; the record must stay where it is.
RTCGeometry NewCurves(RTCDevice device, const CurveRecord *record);

}  // namespace pbrt
