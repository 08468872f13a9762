#pragma once

#include "pbrt/base/integrator.h"
#include "pbrt/build/null_transmission.h"

namespace pbrt {

/// Shadow rays end this much of their length before the light's surface.
inline constexpr float kShadowEnd = 1 - 1e-4f;

/// Share of light that reaches `from` from `to`: 0 or 1, but where surfaces of null transmission
/// stand between.
inline float Visibility(const RenderScene &scene, Point3f from, Point3f to, float time,
                        RayCounts *counts) {
    ++counts->shadow;
    const Ray ray{from, to - from, kShadowEnd, time};
    if (scene.accel->HasNullTransmission())
        return scene.accel->Transmittance(ray, NullTransmissionOf(scene));
    return scene.accel->Occluded(ray) ? 0 : 1;
}

/// Index of the light that a hit belongs to; -1: it does not emit.
inline int LightAt(const RenderScene &scene, const Hit &hit) {
    const Geometry &geometry = scene.geometries[hit.geometry];
    return geometry.firstLight < 0 ? -1 : RenderScene::LightOf(geometry, hit.primitive);
}

}  // namespace pbrt
