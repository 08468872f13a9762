#include "pbrt/build/visible_surface.h"

#include "pbrt/build/material_frame.h"
#include "pbrt/bxdfs/albedo.h"
#include "pbrt/materials/materials.h"

namespace pbrt {

std::optional<VisibleSurface> FindVisibleSurface(const RenderScene &scene, const Ray &ray,
                                                 SampledWavelengths lambda) {
    Hit hit;
    if (!scene.accel->Intersect(ray, &hit)) return {};
    const SurfaceInteraction sp = scene.SurfaceAt(hit, ray);
    const TextureEvalContext ctx = scene.TextureContext(sp);
    VisibleSurface seen{sp.p, sp.n, sp.ns, sp.uv, {}, {}, {}};
    ApproximateStep(scene.camera, sp.p, sp.n, 1, &seen.dpdx, &seen.dpdy);
    const MaterialId id = scene.MaterialMet(scene.geometries[hit.geometry].material, sp, ray.d);
    seen.albedo = Dispatch(scene.materials.Data()[id], [&](const auto &material) {
        const Vector3f wo = FrameOf(material, sp, ctx, ray.d).ToLocal(-ray.d);
        return AlbedoOf(material.GetBxDF(ctx, lambda), wo);
    });
    return seen;
}

}  // namespace pbrt
