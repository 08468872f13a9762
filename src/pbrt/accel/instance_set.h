#pragma once

#include <span>
#include <vector>

#include "pbrt/accel/query.h"
#include "pbrt/base/ray_tracer.h"

namespace pbrt {

/// Instances at rest as one Embree geometry, whose callbacks take rays into the objects' scenes. It
/// takes 4 bytes an instance beside the tree, and the inverse matrices that the instances have;
/// Embree inverts in float.
struct InstanceSet {
    std::span<const Instance> instances;
    std::span<const RTCScene> objects;  ///< by Instance::object
    uint32_t firstId;                   ///< stands in hits for instances[0]
    std::vector<uint32_t> resting;      ///< primitives: indices into `instances`
};

/// Makes the Embree geometry; the set, and what it refers to, must stay where they are.
RTCGeometry NewInstances(RTCDevice device, const InstanceSet *set);

}  // namespace pbrt
