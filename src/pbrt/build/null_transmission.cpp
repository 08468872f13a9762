#include "pbrt/build/null_transmission.h"

#include "pbrt/build/surface_bsdf.h"

namespace pbrt {
namespace {

float NullTransmissionOfOne(const RenderScene &scene, MaterialId id, const SurfaceInteraction &sp,
                            Vector3f d) {
    const Material &any = scene.materials.Data()[id];
    return Dispatch(any, [&]<typename M>(const M &material) -> float {
        if constexpr (M::kTraits.nullTransmission) {
            const TextureEvalContext ctx = scene.materials.Facts(size_t(id)).isUniform
                                               ? TextureEvalContext{}
                                               : scene.TextureContext(sp);
            const Frame frame = BSDFFrame(any, material, sp, ctx, d);
            return material.NullTransmission(ctx, frame.ToLocal(Normalize(-d)));
        } else {
            return 0;
        }
    });
}

/// Share of light from direction d that passes straight through; of a mix, the expected one.
float NullTransmissionAt(const RenderScene &scene, MaterialId id, const SurfaceInteraction &sp,
                         Vector3f d) {
    const MixMaterial *const mix = scene.AsMix(id);
    if (!mix) return NullTransmissionOfOne(scene, id, sp, d);
    const float share = mix->amount.Evaluate(scene.TextureContext(sp));
    float gap = 0;
    if (share < 1) gap += (1 - share) * NullTransmissionAt(scene, mix->materials[0], sp, d);
    if (share > 0) gap += share * NullTransmissionAt(scene, mix->materials[1], sp, d);
    return gap;
}

}  // namespace

float NullTransmissionOf::operator()(const Hit &hit, const Ray &ray) const {
    const SurfaceInteraction sp = scene.SurfaceAtWithoutError(hit, ray);
    return NullTransmissionAt(scene, scene.geometries[hit.geometry].material, sp, ray.d);
}

}  // namespace pbrt
