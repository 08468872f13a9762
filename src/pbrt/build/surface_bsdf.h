#pragma once

#include <algorithm>

#include "pbrt/build/visit_bsdf.h"
#include "pbrt/bxdfs/albedo.h"
#include "pbrt/bxdfs/diffuse_bxdf.h"
#include "pbrt/materials/materials.h"

namespace pbrt {

/// The frame in which a material's BSDF lives, for a ray of direction d; sp: with its relief.
template <MaterialType M>
Frame BSDFFrame(const M &material, const SurfaceInteraction &sp, const TextureEvalContext &ctx,
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
/// The same with the relief of `any`, which holds `material`; sp: without.
template <MaterialType M>
Frame BSDFFrame(const Material &any, const M &material, const SurfaceInteraction &sp,
                const TextureEvalContext &ctx, Vector3f d) {
    if (!any.bump) [[likely]]
        return BSDFFrame(material, sp, ctx, d);
    SurfaceInteraction tilted = sp;
    any.bump->Tilt(ctx, &tilted);
    return BSDFFrame(material, tilted, ctx, d);
}

/// The matte surface that reflects as much towards wo as `bxdf`, at most 1: what Option
/// "forcediffuse" makes of every surface. Mirrors and glass become matte, and nothing is let
/// through. pbrt-v4 takes a random estimate of the same; this one has the errors of AlbedoOf.
template <BxDFType B>
DiffuseBxDF DiffuseOf(const B &bxdf, Vector3f wo) {
    SampledSpectrum albedo = AlbedoOf(bxdf, wo);
    for (int k = 0; k < NSpectrumSamples; ++k)
        albedo.Set(k, std::min(albedo[k], 1.f));
    return DiffuseBxDF(albedo);
}

template <typename F>
decltype(auto) VisitBSDF(const RenderScene &scene, const Hit &hit, const SurfaceInteraction &sp,
                         const Ray &ray, SampledWavelengths *lambda, ClampCounts *clamped,
                         F &&visit) {
    const MaterialId id =
        scene.MaterialMet(scene.geometries[hit.geometry].material, sp, ray.d, clamped);
    const TextureEvalContext ctx = scene.TextureContext(sp, clamped);
    const Material &any = scene.materials.Data()[id];
    return Dispatch(any, [&](const auto &material) {
        const Frame frame = BSDFFrame(any, material, sp, ctx, ray.d);
        const auto bxdf = material.GetBxDF(ctx, *lambda);
        if (scene.options.forceDiffuse) [[unlikely]]
            return visit(frame, DiffuseOf(bxdf, frame.ToLocal(-ray.d)));
        return visit(frame, bxdf);
    });
}

}  // namespace pbrt
