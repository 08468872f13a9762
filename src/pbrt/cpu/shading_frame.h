#pragma once

#include "pbrt/shapes/surface_point.h"
#include "pbrt/textures/texture.h"

namespace pbrt {

/// The frame in which a material's BSDF lives.
template <typename M>
Frame FrameFor(const M &material, const SurfacePoint &sp, const TextureEvalContext &ctx) {
    if constexpr (requires { M::kIsotropic; })
        return Frame::FromZ(sp.ns);
    else if constexpr (requires { material.TurnFrame(Frame(), ctx); })
        return material.TurnFrame(sp.ShadingFrame(), ctx);
    else
        return sp.ShadingFrame();
}

}  // namespace pbrt
