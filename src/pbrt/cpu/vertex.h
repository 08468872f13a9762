#pragma once

#include "pbrt/bxdfs/bxdf.h"
#include "pbrt/cpu/path_state.h"
#include "pbrt/cpu/shading_frame.h"
#include "pbrt/cpu/world.h"

namespace pbrt {

inline float PowerHeuristic(float f, float g) {
    if (f > 1e18f) return 1;
    return f * f / (f * f + g * g);
}

/// BSDFs as their materials make them. bench/sampling passes one of its own, to compare with.
struct BSDFAsItIs {
    template <typename M>
    static auto At(const M &material, const TextureEvalContext &ctx, SampledWavelengths &lambda) {
        return material.GetBxDF(ctx, lambda);
    }
};

/// One vertex of a path, for any material: light that it gives, light that it may receive, and
/// where the path goes on. Multiple importance sampling of lights and BSDF with the power
/// heuristic, Russian roulette after the first bounce.
///
/// Gaps: a path that passes a gap goes straight on with the weights of the vertex it came from and
/// does not count as a bounce; shadow rays take each surface's gap fraction. Both estimate the same
/// light, so the weights of the two ways still add to 1.
template <typename Scattering = BSDFAsItIs>
class PathVertex {
  public:
    /// Refers to all of these. The wavelengths may lose the secondary ones; `L` gains what the path
    /// finds; `shadow` is set.
    PathVertex(const World &world, PathState &path, SampledWavelengths &lambda, SampledSpectrum &L,
               ShadowTest &shadow)
        : world(world), path(path), lambda(lambda), L(L), shadow(shadow) {
        shadow.light = SampledSpectrum(0);
    }

    /// Where the ray leaves the scene.
    void Miss() {
        for (int i : world.infiniteLights) {
            const Light &light = world.lights[i];
            const SampledSpectrum Le = pbrt::Le(light, path.ray, lambda);
            const float lightPDF = path.bsdfPDF == 0
                                       ? 0
                                       : world.lightSampler.PMF(path.previous, i) *
                                             PDF_Li(light, path.previous, path.ray.d);
            L += path.beta * Le * WeightOfFound(lightPDF);
        }
    }

    /// Where it meets a surface. False where the path ends; else path.ray is the next one.
    bool Meet(const Hit &hit, const VertexNumbers &numbers) {
        const Geometry &geometry = world.geometries[hit.geometry];
        if (IsLast() && geometry.firstLight < 0 && !geometry.passesLight) return false;
        const SurfacePoint sp = world.Interact(hit, path.ray);
        if (geometry.firstLight >= 0) AddEmission(geometry, hit, sp);
        return std::visit([&](const auto &material) { return Scatter(material, sp, numbers); },
                          world.MaterialMet(geometry.material, sp, path.ray.d));
    }

    void AddEmission(const Geometry &geometry, const Hit &hit, const SurfacePoint &sp) {
        const int index = World::LightOf(geometry, hit);
        const SampledSpectrum Le =
            pbrt::L(world.lights[index], sp.p, sp.n, sp.uv, -path.ray.d, lambda);
        if (!Le) return;
        float lightPDF = 0;
        if (path.bsdfPDF != 0)
            lightPDF = world.lightSampler.PMF(path.previous, index) *
                       PDF_Hit(world.lights[index], path.previous, path.ray.d, sp.p, sp.n);
        L += path.beta * Le * WeightOfFound(lightPDF);
    }

  private:
    bool IsLast() const { return path.depth == world.path.maxDepth; }

    /// Weight of light found by following the BSDF, `lightPDF` being what light sampling would have
    /// drawn it with from the last vertex.
    float WeightOfFound(float lightPDF) const {
        if (path.bsdfPDF == 0 || lightPDF == 0) return 1;  // camera, delta lobe; not light-sampled
        switch (world.path.strategy) {
            case LightStrategy::LightsOnly:
                return 0;
            case LightStrategy::BSDFOnly:
                return 1;
            default:
                return PowerHeuristic(path.bsdfPDF, lightPDF);
        }
    }

    template <typename M>
    bool Scatter(const M &material, const SurfacePoint &sp, const VertexNumbers &numbers) {
        if (IsLast() && !PassesLight<M>) return false;
        const TextureEvalContext ctx = world.TextureContext(sp);
        const Frame frame = FrameFor(material, sp, ctx);
        const Vector3f wo = frame.ToLocal(-path.ray.d);
        if (wo.z == 0) return false;
        if constexpr (PassesLight<M>)
            if (IsLast()) return PassLastGap(sp, material.GapFraction(ctx, wo));

        auto bsdf = Scattering::At(material, ctx, lambda);
        if (world.path.regularize && path.anyNonSpecular) bsdf.Regularize();
        if (IsNonSpecular(bsdf.Flags()) && world.path.strategy != LightStrategy::BSDFOnly)
            SampleLights(bsdf, sp, frame, wo, numbers);
        const auto s =
            bsdf.Sample_f(wo, numbers.lobe, numbers.direction, TransportMode::Radiance);
        if (!s || s->pdf == 0 || s->wi.z == 0 || !s->f) return false;
        return Continue(*s, bsdf.Flags(), sp, frame, numbers.roulette);
    }

    /// After the last scattering only straight passage is left: take its expectation.
    bool PassLastGap(const SurfacePoint &sp, float gap) {
        if (gap == 0) return false;
        path.beta *= gap;
        path.ray.o = sp.OffsetOrigin(path.ray.d);
        return true;
    }

    bool Continue(const BSDFSample &s, BxDFFlags flags, const SurfacePoint &sp, const Frame &frame,
                  float roulette) {
        path.beta *= s.f * (std::abs(s.wi.z) / s.pdf);
        if (Has(s.flags, BxDFFlags::Gap)) {
            path.ray.o = sp.OffsetOrigin(path.ray.d);
            return Survives(roulette);
        }
        const bool specular = IsSpecular(s.flags);
        path.anyNonSpecular |= !specular;
        if (Has(s.flags, BxDFFlags::Transmission)) path.etaScale *= Sqr(s.eta);
        const Vector3f d = frame.FromLocal(s.wi);
        path.bsdfPDF = specular ? 0 : s.pdf;
        path.previous = ContextAt(sp, flags);
        path.ray.o = sp.OffsetOrigin(d);
        path.ray.d = d;
        ++path.depth;
        return Survives(roulette);
    }

    /// Russian roulette, from the second bounce on.
    bool Survives(float roulette) {
        const float importance = (path.beta * path.etaScale).MaxComponentValue();
        if (!(importance > 0)) return false;
        if (importance >= 1 || path.depth <= 1) return true;
        if (roulette >= importance) return false;
        path.beta *= 1 / importance;
        return true;
    }

    static LightSampleContext ContextAt(const SurfacePoint &sp, BxDFFlags flags) {
        if (IsReflective(flags) && IsTransmissive(flags)) return {sp.p, {}, {}};
        return {sp.p, sp.n, sp.ns};
    }

    template <typename B>
    void SampleLights(const B &bsdf, const SurfacePoint &sp, const Frame &frame, Vector3f wo,
                      const VertexNumbers &numbers) {
        const LightSampleContext ctx = ContextAt(sp, bsdf.Flags());
        const auto chosen = world.lightSampler.Sample(ctx, numbers.light);
        if (!chosen) return;
        const auto ls = SampleLi(world.lights[chosen->light], ctx, numbers.lightPoint, lambda);
        if (!ls || !(ls->pdf > 0)) return;
        const Vector3f wi = frame.ToLocal(ls->wi);
        if (wi.z == 0) return;
        const SampledSpectrum f = bsdf.f(wo, wi, TransportMode::Radiance) * std::abs(wi.z);
        if (!f) return;
        const float lightPDF = chosen->pmf * ls->pdf;
        float weight = 1 / lightPDF;
        if (!ls->delta && world.path.strategy == LightStrategy::Both)
            weight *= PowerHeuristic(lightPDF, bsdf.PDF(wo, wi, TransportMode::Radiance));
        shadow = {sp.OffsetOrigin(ls->wi), ls->pLight, path.beta * f * ls->L * weight};
    }

    const World &world;
    PathState &path;
    SampledWavelengths &lambda;
    SampledSpectrum &L;
    ShadowTest &shadow;
};

}  // namespace pbrt
