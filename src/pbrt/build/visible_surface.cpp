#include "pbrt/build/visible_surface.h"

#include "pbrt/bxdfs/albedo.h"

namespace pbrt {
namespace {

/// The frame in which a material's BSDF lives.
template <typename M>
Frame FrameFor(const M &material, const SurfaceInteraction &sp, const TextureEvalContext &ctx,
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

}  // namespace

std::optional<VisibleSurface> FindVisibleSurface(const RenderScene &scene, const Ray &ray,
                                                 SampledWavelengths lambda) {
    Hit hit;
    if (!scene.accel->Intersect(ray, &hit)) return {};
    const SurfaceInteraction sp = scene.SurfaceAt(hit, ray);
    const TextureEvalContext ctx = scene.TextureContext(sp);
    VisibleSurface seen{sp.p, sp.n, sp.ns, sp.uv, {}, {}, {}};
    scene.camera.ApproximateStep(sp.p, sp.n, 1, &seen.dpdx, &seen.dpdy);
    seen.albedo = std::visit(
        [&](const auto &material) {
            const Vector3f wo = FrameFor(material, sp, ctx, ray.d).ToLocal(-ray.d);
            return AlbedoOf(material.GetBxDF(ctx, lambda), wo);
        },
        scene.materials[size_t(
            scene.MaterialMet(scene.geometries[hit.geometry].material, sp, ray.d))]);
    return seen;
}

}  // namespace pbrt
