#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "pbrt/accel/query.h"
#include "pbrt/accel/world_sphere.h"
#include "pbrt/shapes/intersect.h"

namespace pbrt {

/// One sphere, disk or cylinder in a scene's set of them.
struct QuadricRecord {
    GeometryRecord common;
    std::optional<WorldSphere> ball;  ///< where it is one and without alpha
    /// What a ball that lets no light through does not need.
    std::unique_ptr<const ObjectFromRender> objectFromRender;

    QuadricRecord(const GeometryRecord &record, const Transform &renderFromObject);
};

/// All quadrics of one Embree scene: one geometry, however many there are. Hits carry the
/// quadric's own geometry ID.
using QuadricSet = std::vector<QuadricRecord>;

/// Makes the Embree geometry; the set must stay where it is.
RTCGeometry NewQuadrics(RTCDevice device, const QuadricSet *quadrics);
/// For meshes whose patches are not flat; the record must stay where it is.
RTCGeometry NewBentPatches(RTCDevice device, const GeometryRecord *record);

}  // namespace pbrt
