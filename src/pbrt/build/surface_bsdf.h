#pragma once

#include <algorithm>
#include <variant>

#include "pbrt/build/render_scene.h"
#include "pbrt/bxdfs/albedo.h"
#include "pbrt/bxdfs/diffuse.h"

namespace pbrt {

/// The frame in which a material's BSDF lives, for a ray of direction d.
template <typename M>
Frame BSDFFrame(const M &material, const SurfaceInteraction &sp, const TextureEvalContext &ctx,
                Vector3f d) {
    if constexpr (requires { M::kIsotropic; })
        return Frame::FromZ(sp.ns);
    else if constexpr (IsFibre<M>)
        return sp.FibreFrame(d);
    else if constexpr (TurnsFrame<M>)
        return material.TurnFrame(sp.ShadingFrame(), ctx);
    else
        return sp.ShadingFrame();
}

/// The matte surface that reflects as much towards wo as `bxdf`, at most 1: what Option
/// "forcediffuse" makes of every surface. Mirrors and glass become matte, and nothing is let
/// through. pbrt-v4 takes a random estimate of the same; this one has the errors of AlbedoOf.
template <BxDFModel B>
DiffuseBxDF DiffuseOf(const B &bxdf, Vector3f wo) {
    SampledSpectrum albedo = AlbedoOf(bxdf, wo);
    for (int k = 0; k < NSpectrumSamples; ++k)
        albedo.Set(k, std::min(albedo[k], 1.f));
    return DiffuseBxDF(albedo);
}

/// Calls visit(frame, bxdf) with the BSDF of the surface that `ray` hits, whatever its material; a
/// mix chooses. The material may terminate wavelengths. All calls return the same type.
template <typename F>
decltype(auto) VisitBSDF(const RenderScene &scene, const Hit &hit, const SurfaceInteraction &sp,
                         const Ray &ray, SampledWavelengths *lambda, F &&visit) {
    const MaterialId id = scene.MaterialMet(scene.geometries[hit.geometry].material, sp, ray.d);
    const TextureEvalContext ctx = scene.TextureContext(sp);
    return Dispatch(scene.materials[size_t(id)], [&](const auto &material) {
        const Frame frame = BSDFFrame(material, sp, ctx, ray.d);
        const auto bxdf = material.GetBxDF(ctx, *lambda);
        if (scene.options.forceDiffuse) [[unlikely]]
            return visit(frame, DiffuseOf(bxdf, frame.ToLocal(-ray.d)));
        return visit(frame, bxdf);
    });
}

}  // namespace pbrt
