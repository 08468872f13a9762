#pragma once

#include "pbrt/cpu/path_state.h"
#include "pbrt/cpu/world.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// Weight of light that a path finds by following the BSDF, `lightPDF` being what light sampling
/// would have drawn it with from the last vertex.
inline float WeightOfFound(const World &world, const PathState &path, float lightPDF) {
    if (path.bsdfPDF == 0 || lightPDF == 0) return 1;  // camera, delta lobe; not light-sampled
    switch (world.path.strategy) {
        case LightStrategy::LightsOnly:
            return 0;
        case LightStrategy::BSDFOnly:
            return 1;
        default:
            return PowerHeuristic(path.bsdfPDF, lightPDF);
    }
}

/// What the path gains where its ray leaves the scene.
inline SampledSpectrum LightFromInfinity(const World &world, const PathState &path,
                                         const SampledWavelengths &lambda) {
    SampledSpectrum sum(0);
    for (int i : world.infiniteLights) {
        const Light &light = world.lights[size_t(i)];
        float lightPDF = 0;
        if (path.bsdfPDF != 0)
            lightPDF =
                world.lightSampler.PMF(path.previous, i) * PDF_Li(light, path.previous, path.ray.d);
        sum += Le(light, path.ray, lambda) * WeightOfFound(world, path, lightPDF);
    }
    return path.beta * sum;
}

/// What the path gains where its ray meets an emissive surface.
inline SampledSpectrum LightOfSurface(const World &world, const PathState &path,
                                      const Geometry &geometry, uint32_t primitive,
                                      const SurfacePoint &sp, const SampledWavelengths &lambda) {
    const int index = World::LightOf(geometry, primitive);
    const Light &light = world.lights[size_t(index)];
    const SampledSpectrum Le = L(light, sp.p, sp.n, sp.uv, -path.ray.d, lambda);
    if (!Le) return Le;
    float lightPDF = 0;
    if (path.bsdfPDF != 0)
        lightPDF = world.lightSampler.PMF(path.previous, index) *
                   PDF_Hit(light, path.previous, path.ray.d, sp.p, sp.n);
    return path.beta * Le * WeightOfFound(world, path, lightPDF);
}

}  // namespace pbrt
