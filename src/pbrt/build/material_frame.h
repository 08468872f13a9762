#pragma once

#include "pbrt/base/material.h"
#include "pbrt/shapes/surface_interaction.h"

namespace pbrt {

/// The frame in which the material's BxDF lives where a ray of direction d meets the surface.
template <MaterialType M>
Frame FrameOf(const M &material, const SurfaceInteraction &sp, const TextureEvalContext &ctx,
              Vector3f d) {
    if constexpr (M::kTraits.isotropic)
        return Frame::FromZ(sp.ns);
    else if constexpr (M::kTraits.fibre)
        return sp.FibreFrame(d);
    else if constexpr (M::kTraits.turnsFrame)
        return material.TurnFrame(sp.ShadingFrame(), ctx);
    else
        return sp.ShadingFrame();
}

}  // namespace pbrt
