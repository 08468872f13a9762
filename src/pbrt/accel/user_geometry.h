#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pbrt/accel/object_from_render.h"
#include "pbrt/accel/query.h"
#include "pbrt/accel/world_sphere.h"

namespace pbrt {

void SetBounds(const Bounds3f &b, RTCBounds *out);
/// An Embree geometry of `count` primitives that callbacks bound and meet; they get `user`.
RTCGeometry NewByCallbacks(RTCDevice device, const void *user, size_t count,
                           RTCBoundsFunction bounds, RTCIntersectFunctionN intersect,
                           RTCOccludedFunctionN occluded);

/// One shape with an object space in a scene's set of them.
struct PlacedRecord {
    GeometryRecord common;
    std::optional<WorldSphere> ball;  ///< set for a WorldSphere without alpha
    /// Null for a `ball` that lets no light through: it is met in rendering space.
    std::unique_ptr<const ObjectFromRender> objectFromRender;

    PlacedRecord(const GeometryRecord &record, const Transform &renderFromObject);
};

/// All such shapes of one Embree scene: one geometry, however many there are. Hits carry the
/// shape's own geometry ID.
using PlacedSet = std::vector<PlacedRecord>;

/// Makes the Embree geometry; the set must stay where it is.
RTCGeometry NewPlaced(RTCDevice device, const PlacedSet *set);

/// For the primitives of one self-intersecting shape in rendering space; the record must stay where
/// it is.
RTCGeometry NewUserGeometry(RTCDevice device, const GeometryRecord *record);

}  // namespace pbrt
