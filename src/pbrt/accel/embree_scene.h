#pragma once

#include "pbrt/accel/impl.h"

namespace pbrt {

/// The Embree scene that an Accel has built, for benchmarks of Embree alone.
struct EmbreeSceneOf {
    RTCScene scene;
    explicit EmbreeSceneOf(const Accel &accel) : scene(accel.impl->scene) {}
};

}  // namespace pbrt
