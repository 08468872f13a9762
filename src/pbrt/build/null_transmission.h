#pragma once

#include "pbrt/build/render_scene.h"

namespace pbrt {

/// Share of light along a ray that passes the surfaces with gaps that it meets.
struct NullTransmissionOf final : NullTransmission {
    explicit NullTransmissionOf(const RenderScene &scene) : scene(scene) {}
    float operator()(const Hit &hit, const Ray &ray) const override;

    const RenderScene &scene;
};

}  // namespace pbrt
