#pragma once

#include "pbrt/shapes/bilinear.h"
#include "pbrt/shapes/curve.h"
#include "pbrt/shapes/quadric.h"
#include "pbrt/shapes/surface_point.h"
#include "pbrt/shapes/triangle.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

template <bool kWithError>
inline SurfacePoint InteractWith(const Shape &shape, const Hit &hit, const Ray &ray) {
    switch (shape.index()) {
        case 0:
            return InteractTriangle<kWithError>(*std::get_if<0>(&shape), hit);
        case 1:
            return InteractBilinear<kWithError>(*std::get_if<1>(&shape), hit);
        case 2:
            return InteractSphere<kWithError>(*std::get_if<2>(&shape), hit, ray);
        case 3:
            return InteractDisk<kWithError>(*std::get_if<3>(&shape), hit, ray);
        case 4:
            return InteractCylinder<kWithError>(*std::get_if<4>(&shape), hit, ray);
        default:
            return InteractCurve(*std::get_if<5>(&shape), hit, ray);
    }
}

/// Everything about a hit that shading needs. `hit.t` along `ray`; for instances the ray and the
/// result are in the instance's object space.
inline SurfacePoint Interact(const Shape &shape, const Hit &hit, const Ray &ray) {
    return InteractWith<true>(shape, hit, ray);
}

/// Interact without pError: for alpha tests and gaps, where no ray starts.
inline SurfacePoint InteractLightly(const Shape &shape, const Hit &hit, const Ray &ray) {
    return InteractWith<false>(shape, hit, ray);
}

}  // namespace pbrt
