#pragma once

#include "pbrt/integrators/path/path_batch.h"
#include "pbrt/integrators/path/settings.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// Weight of light that a path finds by following the BSDF, `lightPDF` being what light sampling
/// would have drawn it with from the last vertex.
inline float MISWeight(const PathSettings &settings, const PathState &path, float lightPDF) {
    if (path.bsdfPDF == 0 || lightPDF == 0) return 1;  // camera, delta lobe; not light-sampled
    switch (settings.strategy) {
        case LightStrategy::LightsOnly:
            return 0;
        case LightStrategy::BSDFOnly:
            return 1;
        default:
            return PowerHeuristic(path.bsdfPDF, lightPDF);
    }
}

/// What a path gains of the infinite light number `index` where its ray leaves the scene: Le times
/// its weight, `density` being that of the light's own sampling.
inline SampledSpectrum EscapedRadiance(const PathSettings &settings, const PathState &path,
                                       int index, SampledSpectrum Le, float density) {
    float lightPDF = 0;
    if (path.bsdfPDF != 0 && density != 0)
        lightPDF = settings.lightSampler.PMF(path.previous, index) * density;
    return path.beta * Le * MISWeight(settings, path, lightPDF);
}

/// Adds that of all infinite lights to batch.L, for the given lanes.
inline void AddEscapedRadiance(const RenderScene &scene, const PathSettings &settings,
                               const PathPacket &paths, LaneBits lanes, PathBatch *batch) {
    for (int index : scene.infiniteLights) {
        const Light &light = scene.lights[size_t(index)];
        const auto *const image = std::get_if<ImageInfiniteLight>(&light);
        const auto place = image ? image->Along(paths.d) : ImageInfiniteLight::Place<FloatX16>();
        ForEachLane(lanes, [&](int i) {
            const SampledWavelengths &lambda = batch->lambda[paths.slot[i]];
            const PathState path = paths.At(i);
            const SampledSpectrum Le = image ? image->RadianceAt(Lane(place.p, i), lambda)
                                             : pbrt::Le(light, path.ray, lambda);
            batch->L[paths.slot[i]] +=
                EscapedRadiance(settings, path, index, Le, image ? place.pdf[i] : 0);
        });
    }
}

/// What the path gains where its ray meets an emissive surface.
inline SampledSpectrum EmittedRadiance(const RenderScene &scene, const PathSettings &settings,
                                       const PathState &path, const Geometry &geometry,
                                       uint32_t primitive, const SurfaceInteraction &sp,
                                       const SampledWavelengths &lambda) {
    const int index = RenderScene::LightOf(geometry, primitive);
    const Light &light = scene.lights[size_t(index)];
    const SampledSpectrum Le = L(light, sp.p, sp.n, sp.uv, -path.ray.d, lambda);
    if (!Le) return Le;
    float lightPDF = 0;
    if (path.bsdfPDF != 0)
        lightPDF = settings.lightSampler.PMF(path.previous, index) *
                   PDF_Hit(light, path.previous, path.ray.d, sp.p, sp.n);
    return path.beta * Le * MISWeight(settings, path, lightPDF);
}

}  // namespace pbrt
