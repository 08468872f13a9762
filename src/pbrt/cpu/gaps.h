#pragma once

#include "pbrt/cpu/world.h"

namespace pbrt {

/// Share of light along a ray that passes the surfaces with gaps that it meets.
struct GapsOf final : GapTransmittance {
    explicit GapsOf(const World &world) : world(world) {}
    float operator()(const Hit &hit, const Ray &ray) const override;

    const World &world;
};

}  // namespace pbrt
