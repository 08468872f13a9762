#pragma once

#include "pbrt/shapes/bilinear.h"
#include "pbrt/shapes/curve.h"
#include "pbrt/shapes/quadric.h"
#include "pbrt/shapes/surface_interaction.h"
#include "pbrt/shapes/triangle.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

template <bool kWithError>
inline SurfaceInteraction SurfaceAtWith(const Shape &shape, const Hit &hit, const Ray &ray) {
    switch (shape.index()) {
        case 0:
            return TriangleSurface<kWithError>(*std::get_if<0>(&shape), hit);
        case 1:
            return BilinearSurface<kWithError>(*std::get_if<1>(&shape), hit);
        case 2:
            return SphereSurface<kWithError>(*std::get_if<2>(&shape), hit, ray);
        case 3:
            return DiskSurface<kWithError>(*std::get_if<3>(&shape), hit, ray);
        case 4:
            return CylinderSurface<kWithError>(*std::get_if<4>(&shape), hit, ray);
        default:
            return CurveSurface(*std::get_if<5>(&shape), hit, ray);
    }
}

/// Everything about a hit that shading needs. `hit.t` along `ray`; for instances the ray and the
/// result are in the instance's object space.
inline SurfaceInteraction SurfaceAt(const Shape &shape, const Hit &hit, const Ray &ray) {
    return SurfaceAtWith<true>(shape, hit, ray);
}

/// SurfaceAt without pError: for alpha tests and gaps, where no ray starts.
inline SurfaceInteraction SurfaceAtWithoutError(const Shape &shape, const Hit &hit,
                                                const Ray &ray) {
    return SurfaceAtWith<false>(shape, hit, ray);
}

}  // namespace pbrt
