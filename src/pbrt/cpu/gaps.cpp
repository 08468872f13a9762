#include "pbrt/cpu/gaps.h"

namespace pbrt {
namespace {

template <typename M>
float GapFractionOf(const World &world, const M &material, bool plain, const SurfacePoint &sp,
                    Vector3f d) {
    if constexpr (PassesLight<M>) {
        const TextureEvalContext ctx = plain ? TextureEvalContext{} : world.TextureContext(sp);
        const Frame frame = material.TurnFrame(sp.ShadingFrame(), ctx);
        return material.GapFraction(ctx, frame.ToLocal(Normalize(-d)));
    } else {
        return 0;
    }
}

/// Of a mix: what is expected of its choice.
float GapFractionOf(const World &world, MaterialId id, const SurfacePoint &sp, Vector3f d) {
    const MixMaterial *const mix = world.AsMix(id);
    if (!mix) {
        return std::visit(
            [&](const auto &m) { return GapFractionOf(world, m, world.plain[id], sp, d); },
            world.materials[id]);
    }
    const float share = mix->amount.Evaluate(world.TextureContext(sp));
    float gap = 0;
    if (share < 1) gap += (1 - share) * GapFractionOf(world, mix->materials[0], sp, d);
    if (share > 0) gap += share * GapFractionOf(world, mix->materials[1], sp, d);
    return gap;
}

}  // namespace

float GapsOf::operator()(const Hit &hit, const Ray &ray) const {
    const SurfacePoint sp = world.InteractLightly(hit, ray);
    return GapFractionOf(world, world.geometries[hit.geometry].material, sp, ray.d);
}

}  // namespace pbrt
