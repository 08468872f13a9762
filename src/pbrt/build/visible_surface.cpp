#include "pbrt/build/visible_surface.h"

#include "pbrt/build/surface_bsdf.h"

namespace pbrt {

std::optional<VisibleSurface> FindVisibleSurface(const RenderScene &scene, const Ray &ray,
                                                 SampledWavelengths lambda) {
    Hit hit;
    if (!scene.accel->Intersect(ray, &hit)) return {};
    const SurfaceInteraction sp = scene.SurfaceAt(hit, ray);
    VisibleSurface seen{sp.p, sp.n, sp.ns, sp.uv, {}, {}, {}};
    ApproximateStep(scene.camera, sp.p, sp.n, 1, &seen.dpdx, &seen.dpdy);
    seen.albedo =
        VisitBSDF(scene, hit, sp, ray, &lambda, nullptr, [&](const Frame &frame, const auto &bxdf) {
            // A fibre's frame faces the ray, its normal need not.
            seen.ns = Dot(frame.z, sp.ns) < 0 ? -frame.z : frame.z;
            return AlbedoOf(bxdf, frame.ToLocal(-ray.d));
        });
    return seen;
}

}  // namespace pbrt
