#pragma once

#include "pbrt/integrators/path/path_batch.h"
#include "pbrt/integrators/path/settings.h"
#include "pbrt/lights/light_packet.h"
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

/// Gain of a path from the infinite light number `index` where its ray leaves the scene: Le times
/// beta and the MIS weight, `density` being that of the light's own sampling.
inline SampledSpectrum EscapedRadiance(const PathSettings &settings, const PathState &path,
                                       int index, SampledSpectrum Le, float density) {
    float lightPDF = 0;
    if (path.bsdfPDF != 0 && density != 0)
        lightPDF = settings.lightSampler.PMF(path.previous, index) * density;
    return path.beta * Le * MISWeight(settings, path, lightPDF);
}

/// Adds the gain from all infinite lights to batch.L, for the given lanes.
inline void AddEscapedRadiance(const RenderScene &scene, const PathSettings &settings,
                               const PathPacket &paths, LaneBits lanes, PathBatch *batch) {
    WavelengthPacket lambda{};
    ForEachLane(lanes, [&](int i) { lambda[size_t(i)] = &batch->lambda[paths.slot[i]]; });
    for (int index : scene.infiniteLights) {
        LightLePacket le;
        Le(scene.lights[size_t(index)], paths.o, paths.d, lambda, lanes, &le);
        ForEachLane(lanes, [&](int i) {
            batch->L[paths.slot[i]] +=
                EscapedRadiance(settings, paths.At(i), index, le.L[size_t(i)], le.pdf[i]);
        });
    }
}

/// Gain of a path where its ray meets an emissive surface: Le times beta and the MIS weight.
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
                   PDF_Hit(light, path.previous, sp.p, sp.n);
    return path.beta * Le * MISWeight(settings, path, lightPDF);
}

}  // namespace pbrt
