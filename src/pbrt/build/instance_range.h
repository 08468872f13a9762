#pragma once

#include <optional>
#include <span>
#include <string>

#include "pbrt/build/places.h"
#include "pbrt/build/render_scene.h"

namespace pbrt {

/// Why the ray tracer could not place the instance of an object of these bounds, or nothing. It
/// inverts the matrices of moving ones in float by their determinant, which must not over- or
/// underflow, cancel or vanish between two keys; of those at rest the same is asked.
std::optional<std::string> WhyNotPlaced(const Instance &instance, const Bounds3f &object);

/// Reports the first instance in whose own space a ray of the scene would leave the ray tracer's
/// range. The RenderScene is complete but has not been traced; `places`: of its instances in the
/// scene.
void CheckRaysInInstances(const RenderScene &scene, const Places &places, Diagnostics &log);

}  // namespace pbrt
