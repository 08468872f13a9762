#pragma once

#include "pbrt/base/bxdf.h"
#include "pbrt/build/render_scene.h"

namespace pbrt {

/// Calls visit(frame, bxdf) with the BSDF of the surface that `ray` hits, whatever its material; a
/// mix chooses. The material may terminate wavelengths, and counts values out of range
/// unless `clamped` is null. All calls return the same type.
///
/// Defined in surface_bsdf.h, which knows all materials and is compiled anew for each new one:
/// integrators include this, and what instantiates them (one_by_one.h) includes that.
template <typename F>
decltype(auto) VisitBSDF(const RenderScene &scene, const Hit &hit, const SurfaceInteraction &sp,
                         const Ray &ray, SampledWavelengths *lambda, ClampCounts *clamped,
                         F &&visit);

}  // namespace pbrt
