#include "pbrt/build/render_scene.h"

#include "pbrt/shapes/instanced.h"
#include "pbrt/shapes/surface_packet.h"

namespace pbrt {
namespace {

Ray ToObject(const Transform &renderFromObject, const Ray &ray) {
    const Transform objectFromRender = renderFromObject.Inverse();
    return {objectFromRender.Point(ray.o), objectFromRender.Vector(ray.d), ray.tMax, ray.time};
}

template <bool kWithError>
SurfaceInteraction SurfaceIn(const RenderScene &scene, const Hit &hit, const Ray &ray) {
    const Shape &shape = scene.geometries[hit.geometry].shape;
    if (hit.instance == ~0u) [[likely]]
        return SurfaceAtWith<kWithError>(shape, hit, ray);
    const auto placed = [&](const Transform &t) {
        return FromInstance(t, SurfaceAtWith<kWithError>(shape, hit, ToObject(t, ray)));
    };
    return placed(TransformAt(scene.instances[hit.instance], ray.time));
}

}  // namespace

SurfaceInteraction RenderScene::SurfaceAt(const Hit &hit, const Ray &ray) const {
    return SurfaceIn<true>(*this, hit, ray);
}

template <bool kWithTangents>
SurfaceInteractionX16 RenderScene::SurfaceAt(const HitPacket &hits, const RayPacket &rays,
                                             LaneBits lanes) const {
    PacketHits met{{hits, rays.o, rays.d}, {}};
    LaneBits placed = 0;
    ForEachLane(lanes, [&](int i) {
        met.shape[size_t(i)] = &geometries[hits.geometry[i]].shape;
        placed |= LaneBits(hits.instance[i] != ~0u) << i;
    });
    SurfaceInteractionX16 s = SurfacePacket<kWithTangents>(met, lanes & ~placed);
    ForEachLane(placed, [&](int i) { SetLane(&s, i, SurfaceAt(hits.At(i), rays.At(i))); });
    return s;
}
template SurfaceInteractionX16 RenderScene::SurfaceAt<true>(const HitPacket &, const RayPacket &,
                                                            LaneBits) const;
template SurfaceInteractionX16 RenderScene::SurfaceAt<false>(const HitPacket &, const RayPacket &,
                                                             LaneBits) const;

SurfaceInteraction RenderScene::SurfaceAtWithoutError(const Hit &hit, const Ray &ray) const {
    return SurfaceIn<false>(*this, hit, ray);
}

template <typename T>
TextureFootprint<T> RenderScene::FootprintAt(const SurfaceInteractionT<T> &sp) const {
    // Sampling finer than a pixel deserves finer look-ups.
    const float scale = std::max(0.125f, 1 / std::sqrt(float(SamplesPerPixel(sampler))));
    TextureFootprint<T> f;
    ApproximateStep(camera, sp.p, sp.n, scale, &f.dpdx, &f.dpdy);
    // Least squares for (du, dv) in dp = dpdu du + dpdv dv.
    const T a = Dot(sp.dpdu, sp.dpdu), b = Dot(sp.dpdu, sp.dpdv), c = Dot(sp.dpdv, sp.dpdv);
    const T det = a * c - b * b;
    const auto solve = [&](Vec3<T> step, T *du, T *dv) {
        const T x = Dot(sp.dpdu, step), y = Dot(sp.dpdv, step);
        const auto bounded = [&](T v) { return Select(det > 0, Min(Max(v, -1e8f), 1e8f), T{}); };
        *du = bounded((c * x - b * y) / det);
        *dv = bounded((a * y - b * x) / det);
    };
    solve(f.dpdx, &f.dudx, &f.dvdx);
    solve(f.dpdy, &f.dudy, &f.dvdy);
    return f;
}

TextureEvalContext RenderScene::TextureContext(const SurfaceInteraction &sp,
                                               ClampCounts *clamped) const {
    TextureEvalContext ctx{{}, sp.p, sp.n, sp.uv, sp.faceIndex, clamped};
    if (filtersTextures) static_cast<TextureFootprint<float> &>(ctx) = FootprintAt(sp);
    return ctx;
}

void RenderScene::TextureContexts(const SurfaceInteractionX16 &sp, LaneBits lanes,
                                  ClampCounts *clamped,
                                  std::array<TextureEvalContext, kPacketSize> *contexts) const {
    TextureFootprint<FloatX16> steps{};
    if (filtersTextures) steps = FootprintAt(sp);
    ForEachLane(lanes, [&](int i) {
        (*contexts)[size_t(i)] = {Lane(steps, i), Lane(sp.p, i),   Lane(sp.n, i),
                                  Lane(sp.uv, i), sp.faceIndex[i], clamped};
    });
}

uint32_t RenderScene::TopLevelGeometries() const {
    uint32_t first = uint32_t(geometries.size());
    for (const ObjectRange &object : objects)
        first = std::min(first, object.first);
    return first;
}

bool RenderScene::HasNullTransmission(MaterialId id) const {
    if (options.forceDiffuse) return false;
    if (const MixMaterial *mix = AsMix(id))
        return HasNullTransmission(mix->materials[0]) || HasNullTransmission(mix->materials[1]);
    return id >= 0 && materials.Facts(size_t(id)).nullTransmission;
}

}  // namespace pbrt
